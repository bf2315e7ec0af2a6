#include "loosefit/geometry/rotation_between.h"

#include <cmath>

namespace loosefit::geometry {

Eigen::Quaterniond rotation_between(const Vec3& from, const Vec3& to) {
  const Vec3 a = from.normalized(), b = to.normalized();
  const double cosine = b.dot(a);
  if (cosine < -1 + 1e-12) {
    const Vec3 across = a.unitOrthogonal();
    return {0, across.x(), across.y(), across.z()};
  }
  const Vec3 axis = a.cross(b);
  const double twice = std::sqrt((1 + cosine) * 2);  // twice the cosine of half the angle
  const Vec3 imaginary = axis * (1 / twice);
  return {twice * 0.5, imaginary.x(), imaginary.y(), imaginary.z()};
}

}  // namespace loosefit::geometry
