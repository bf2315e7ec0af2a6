#include "loosefit/drape/rolled_panel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/geometry/rotation_between.h"

namespace loosefit::drape {
namespace {

constexpr double kSeamSlit = 0.15;     ///< that its edges stay apart, half [rad]
constexpr double kNextToSkin = 0.006;  ///< at least [m]
constexpr double kStep = 0.01;         ///< by which it is made wider [m]
constexpr int kSteps = 30, kWidths = 5;
constexpr double kLeastRadius = 0.04, kLeastWidth = 0.05;  ///< [m]

}  // namespace

RolledPanel::RolledPanel(const garment::OpenSeams& open, const std::vector<Vec3>& placed, int panel,
                         const Vec3& from, const Vec3& axis, const Vec3& normal)
    : axis_(axis), normal_(normal), across_(normal.cross(axis).normalized()) {
  const std::vector<int>& of = open.garment.vertex_panel;
  for (int v = 0; v < open.garment.vertex_count; ++v)
    if (of[v] == panel) {
      const Vec3 off = placed[v] - from;
      points_.push_back({v, off.dot(axis), off.dot(across_)});
    }
  for (const std::vector<int>& partners : open.partners) {
    double low = std::numeric_limits<double>::infinity(), high = -low, s = 0;
    int own = 0;
    for (int v : partners) {
      if (of[v] != panel) continue;
      const Vec3 off = placed[v] - from;
      low = std::min(low, off.dot(across_)), high = std::max(high, off.dot(across_));
      s += off.dot(axis), ++own;
    }
    if (own > 1 && high - low > kLeastWidth) girths_.push_back({s / own, low, high});
  }
  std::sort(girths_.begin(), girths_.end(),
            [](const Girth& a, const Girth& b) { return a.s < b.s; });
}

RolledPanel::Girth RolledPanel::girth_at(double s) const {
  if (s <= girths_.front().s) return girths_.front();
  if (s >= girths_.back().s) return girths_.back();
  std::size_t i = 1;
  while (girths_[i].s < s) ++i;
  const Girth &a = girths_[i - 1], &b = girths_[i];
  const double t = b.s > a.s ? (s - a.s) / (b.s - a.s) : 1;
  return {s, a.low + t * (b.low - a.low), a.high + t * (b.high - a.high)};
}

void RolledPanel::place(const Polyline& limb, double offset, double wider,
                        std::vector<Vec3>& x) const {
  for (const Point& point : points_) {
    const Girth girth = girth_at(point.s);
    const double half = 0.5 * (girth.high - girth.low);
    const double angle = (point.across - 0.5 * (girth.low + girth.high)) / half * (kPi - kSeamSlit);
    const double radius = std::max(half / kPi, kLeastRadius) + wider;
    const Polyline::Place at = limb.at(offset + point.s);
    const Vec3 round = radius * (std::cos(angle) * normal_ + std::sin(angle) * across_);
    x[point.vertex] = at.point + geometry::rotation_between(axis_, at.tangent) * round;
  }
}

void RolledPanel::place_clear(const Polyline& limb, double offset, double farther,
                              const body::PosedBody& body, std::vector<Vec3>& x) const {
  for (int step = 0; step < kSteps; ++step) {
    place(limb, offset + farther * (step / kWidths), kStep * (farther > 0 ? step % kWidths : step),
          x);
    const bool clear = std::ranges::all_of(points_, [&](const Point& point) {
      return body.tree().signed_distance(x[point.vertex], nullptr, 1.0) > kNextToSkin;
    });
    if (clear) return;
  }
}

}  // namespace loosefit::drape
