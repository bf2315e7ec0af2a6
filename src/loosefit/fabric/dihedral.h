#pragma once
#include "loosefit/base/types.h"

namespace loosefit::fabric {

/// Dihedral angle θ [rad] of the hinge (edge x0 x1, opposite corners x2 of triangle (x0, x1, x2)
/// and x3 of triangle (x1, x0, x3)); 0 when flat.
double dihedral_angle(const Vec3& x0, const Vec3& x1, const Vec3& x2, const Vec3& x3);

}  // namespace loosefit::fabric
