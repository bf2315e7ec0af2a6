#include "loosefit/fabric/bending_friction.h"

#include <cmath>
#include <limits>

namespace loosefit {

BendingFriction::BendingFriction(const Vec2& hysteresis, const Vec2& rigidity) {
  constexpr double kReachShare = 0.1;
  limit_ = hysteresis.maxCoeff();
  if (!active()) return;
  const Vec2 a = hysteresis / limit_;
  scale_ = {a[0], a[1], std::sqrt(0.5 * a[0] * a[1])};
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 2; ++i)
    if (hysteresis[i] > 0) least = std::min(least, a[i] * hysteresis[i] / rigidity[i]);
  reach_ = kReachShare * least;
}

Vec3 BendingFriction::carried(const Vec3& slide, const Vec3& anchor) const {
  const Vec3 z = slide - anchor;
  const double length = z.norm();
  return length > reach_ ? Vec3(slide - (reach_ / length) * z) : anchor;
}

BendingFriction::Response BendingFriction::respond(const Vec3& curvature,
                                                   const Vec3& anchor) const {
  const Vec3 z = slide(curvature) - anchor;
  const double length = z.norm(), s = length / reach_;
  Response r;
  r.energy = limit_ * reach_ * (s < 1 ? s * s * (1 - s / 3) : s - 1.0 / 3.0);
  const double per_length = s < 1 ? (2 - s) / reach_ : 1 / length;  // f₀'/|z|
  r.moment = limit_ * per_length * scale_.cwiseProduct(z);
  Mat3 tangent = per_length * Mat3::Identity();
  if (length > 0) {
    const Vec3 t = z / length;
    tangent -= (s < 1 ? s / reach_ : 1 / length) * t * t.transpose();
  }
  r.tangent = limit_ * scale_.asDiagonal() * tangent * scale_.asDiagonal();
  return r;
}

}  // namespace loosefit
