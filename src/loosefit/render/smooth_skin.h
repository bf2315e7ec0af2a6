#pragma once
#include <vector>

#include "loosefit/body/body.h"

namespace loosefit::render {

/// Places of a body's vertices [m] on a smooth form without anatomy: trunk, neck, arms, legs and
/// feet low-pass filtered (geometry/low_pass.h), the clefts of the trunk filled (fill_clefts.h),
/// and the edges of that filtered away. Head and hands stay as they are. Waves on a trunk shorter
/// than 6 cm lose 95 % and more of their height; a shank of 9 cm becomes some 3 mm thinner.
std::vector<Vec3> smooth_skin(const body::Body& body);

}  // namespace loosefit::render
