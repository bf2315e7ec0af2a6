#pragma once
#include "loosefit/drape/cloth_layer.h"
#include "loosefit/drape/contact_body.h"
#include "loosefit/drape/settling_tuning.h"

namespace loosefit::drape {

/// How several layers go with the body: the motion of each smoothed over its cloth (smoothed_over),
/// but where a layer lies close over others, theirs. Neighbouring layers then move as one smooth
/// field does and do not run into each other, which two fields smoothed apart would.
std::vector<MotionMap> carried_layers(const ClothMesh& cloth, const std::vector<Vec3>& x,
                                      std::vector<MotionMap> motion, const CarryTuning& tuning);

}  // namespace loosefit::drape
