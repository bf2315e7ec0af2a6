#include "loosefit/fabric/bending_friction.h"

#include <cmath>
#include <limits>

namespace loosefit::fabric {

LOOSEFIT_VECTORISED
static void add_friction(const std::array<double, 3>& scale, double limit, double reach,
                         const PlaneRows& curvature, const PlaneRows& anchor,
                         const particles::TileRow& area, PlaneResponse& out) {
  for (int i = 0; i < particles::kTile; ++i) {
    const double z0 = scale[0] * curvature[0][i] - anchor[0][i],
                 z1 = scale[1] * curvature[1][i] - anchor[1][i],
                 z2 = scale[2] * curvature[2][i] - anchor[2][i];
    const double length = std::sqrt(z0 * z0 + z1 * z1 + z2 * z2), s = length / reach;
    const bool slides = s >= 1;
    const double energy = slides ? s - 1.0 / 3.0 : s * s * (1 - s / 3);
    const double per = slides ? 1 / (slides ? length : 1.0) : (2 - s) / reach;
    const double force = area[i] * limit * per;
    out.energy[i] += area[i] * limit * reach * energy;
    out.stress[0][i] += force * scale[0] * z0;
    out.stress[1][i] += force * scale[1] * z1;
    out.stress[2][i] += force * scale[2] * z2;
  }
}

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

void BendingFriction::add(const PlaneRows& curvature, const PlaneRows& anchor,
                          const particles::TileRow& area, PlaneResponse& out) const {
  add_friction({scale_[0], scale_[1], scale_[2]}, limit_, reach_, curvature, anchor, area, out);
}

}  // namespace loosefit::fabric
