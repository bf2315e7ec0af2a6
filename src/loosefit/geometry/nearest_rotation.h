#pragma once
#include "loosefit/base/types.h"

namespace loosefit::geometry {

/// The rotation nearest to a matrix (polar decomposition by singular values; Kabsch 1976): the mean
/// of rotations when given their weighted sum, the best fitting turn when given Σ to fromᵀ. Of a
/// mirror image it gives way where the matrix says least.
Mat3 nearest_rotation(const Mat3& matrix);

}  // namespace loosefit::geometry
