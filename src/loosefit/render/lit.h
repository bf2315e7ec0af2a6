#pragma once
#include "loosefit/render/image.h"

namespace loosefit::render {

/// Light [0, 1] that a scene leaves where no lamp shines.
inline constexpr double kSceneAmbient = 0.25;

/// Colours under a light, both drawn from one view. The light, from kSceneAmbient to 1 in the
/// scene, is lifted to run from `ambient` to 1 and never falls below it, not in the deepest crease
/// either, so that colours stay comparable with the legend. White pixels are background and stay
/// white.
Image lit(Image colours, const Image& light, double ambient);

}  // namespace loosefit::render
