#pragma once
#include "loosefit/drape/cloth_state.h"

namespace loosefit::drape {

/// Smooths the cloth round triangles that still cut at rest (drape/smooth_cuts.h), settles it from
/// there, and certifies it, a few times; goes back to where it was if no fewer cut then.
void smooth_out(ClothState& state);

}  // namespace loosefit::drape
