#pragma once
#include <array>

#include "loosefit/base/types.h"

namespace loosefit {

/// Dihedral angle θ [rad] of the hinge (edge x0 x1, opposite corners x2 of triangle (x0, x1, x2)
/// and x3 of triangle (x1, x0, x3)); 0 when flat. Gradient and Hessian with respect to the four
/// points. Source: Grinspun et al. 2003; Tamstorf and Grinspun 2013, derived anew for this sign
/// convention.
struct Dihedral {
  double angle = 0;
  std::array<Vec3, 4> gradient;
};
using DihedralHessian = std::array<std::array<Mat3, 4>, 4>;
Dihedral dihedral(const Vec3& x0, const Vec3& x1, const Vec3& x2, const Vec3& x3,
                  DihedralHessian* hessian = nullptr);
/// The angle alone.
double dihedral_angle(const Vec3& x0, const Vec3& x1, const Vec3& x2, const Vec3& x3);

}  // namespace loosefit
