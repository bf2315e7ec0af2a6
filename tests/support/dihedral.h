#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "loosefit/base/types.h"

namespace loosefit::support {

/// Dihedral angle as in fabric/dihedral.h with its gradient and Hessian with respect to the four
/// points: the scalar formula, oracle of the kernels for many hinges. Source: Grinspun et al. 2003;
/// Tamstorf and Grinspun 2013, derived anew for this sign convention.
struct Dihedral {
  double angle = 0;
  std::array<Vec3, 4> gradient;
};
using DihedralHessian = std::array<std::array<Mat3, 4>, 4>;

inline Mat3 cross_matrix(const Vec3& a) {
  Mat3 m;
  m << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return m;
}

inline Dihedral dihedral(const Vec3& x0, const Vec3& x1, const Vec3& x2, const Vec3& x3,
                         DihedralHessian* hessian = nullptr) {
  Dihedral d;
  const Vec3 e = x1 - x0;
  const double length = e.norm();
  const Vec3 unit = e / length;
  const Vec3 n1 = e.cross(x2 - x0), n2 = (x3 - x0).cross(e);
  const double q1 = n1.squaredNorm(), q2 = n2.squaredNorm();
  d.angle = std::atan2(n1.cross(n2).dot(unit), n1.dot(n2));
  const Vec3 m1 = n1 / q1, m2 = n2 / q2;
  const double c10 = (x2 - x1).dot(unit), c20 = (x3 - x1).dot(unit);
  const double c11 = (x2 - x0).dot(unit), c21 = (x3 - x0).dot(unit);
  d.gradient = {-(c10 * m1 + c20 * m2), c11 * m1 + c21 * m2, -length * m1, -length * m2};
  if (!hessian) return d;
  DihedralHessian& h = *hessian;

  const Mat3 r1 = (Mat3::Identity() - 2 * n1 * n1.transpose() / q1) / q1;
  const Mat3 r2 = (Mat3::Identity() - 2 * n2 * n2.transpose() / q2) / q2;
  // Derivatives of m1, m2 with respect to the four points.
  const Mat3 zero = Mat3::Zero();
  const std::array<Mat3, 4> dm1 = {r1 * cross_matrix(x2 - x1), -r1 * cross_matrix(x2 - x0),
                                   r1 * cross_matrix(e), zero};
  const std::array<Mat3, 4> dm2 = {-r2 * cross_matrix(x3 - x1), r2 * cross_matrix(x3 - x0), zero,
                                   -r2 * cross_matrix(e)};
  const std::array<Vec3, 4> dlength = {-unit, unit, Vec3::Zero(), Vec3::Zero()};
  const Mat3 project = (Mat3::Identity() - unit * unit.transpose()) / length;
  // c = (p − q)·unit: derivative through unit is ±project (p − q), through p and q is ±unit.
  const auto derivative = [&](const Vec3& difference, int p, int q) {
    std::array<Vec3, 4> dc = {-project * difference, project * difference, Vec3::Zero(),
                              Vec3::Zero()};
    dc[p] += unit;
    dc[q] -= unit;
    return dc;
  };
  const auto dc10 = derivative(x2 - x1, 2, 1), dc20 = derivative(x3 - x1, 3, 1);
  const auto dc11 = derivative(x2 - x0, 2, 0), dc21 = derivative(x3 - x0, 3, 0);
  for (int j = 0; j < 4; ++j) {
    h[0][j] = -(m1 * dc10[j].transpose() + c10 * dm1[j] + m2 * dc20[j].transpose() + c20 * dm2[j]);
    h[1][j] = m1 * dc11[j].transpose() + c11 * dm1[j] + m2 * dc21[j].transpose() + c21 * dm2[j];
    h[2][j] = -(m1 * dlength[j].transpose() + length * dm1[j]);
    h[3][j] = -(m2 * dlength[j].transpose() + length * dm2[j]);
  }
  return d;
}

}  // namespace loosefit::support
