#include "loosefit/placement/address_garment.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/placement/footprint_unfold.h"
#include "loosefit/placement/ray.h"

namespace loosefit::placement {
namespace {

constexpr double kEdgeSlack = 1e-4;    // [m]
constexpr double kNearMiss = 0.015;    // [m]
constexpr double kInnerMiss = 0.060;   // over a furrow that the cloth bridges [m]
constexpr double kSameMiss = 5e-4;     // [m]
constexpr double kCloseEnough = 1e-4;  // [m]
constexpr int kRounds = 8;

Vec3 lifted(const Vec2& p) { return {p.x(), p.y(), 0}; }

std::string far_off(double gap) {
  return fmt::format("the cloth hangs {:.0f} mm off the skin there", 1e3 * gap);
}

std::string place_text(const Vec2& p) {
  const auto round = [](double x) { return shortest(std::round(x * 1e4) / 1e4 + 0.0); };
  return "(" + round(p.x()) + ", " + round(p.y()) + ") m";
}

}  // namespace

Vec2 pattern_place(const garment::Garment& garment, const GarmentPoint& point) {
  const auto& uv = garment.triangle_uv[point.triangle];
  return point.barycentric[0] * uv[0] + point.barycentric[1] * uv[1] + point.barycentric[2] * uv[2];
}

Vec3 at(const garment::Garment& garment, const GarmentPoint& point,
        const std::vector<Vec3>& field) {
  Vec3 value = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
    value += point.barycentric[k] * field[garment.triangles[point.triangle][k]];
  return value;
}

GarmentPoint pattern_point(const garment::Garment& garment, const std::string& panel,
                           const Vec2& place) {
  const auto& names = garment.panel_names;
  const auto found = std::find(names.begin(), names.end(), panel);
  if (found == names.end())
    throw InvalidInput(InputPlace{"", 0, "panel"}, '"' + printable(panel) + '"',
                       "one of " + join(names), did_you_mean(panel, names));
  const int index = static_cast<int>(found - names.begin());
  GarmentPoint best;
  Vec3 nearest = Vec3::Zero();
  double distance = std::numeric_limits<double>::infinity();
  for (int t = 0; t < static_cast<int>(garment.triangles.size()); ++t) {
    if (garment.triangle_panel[t] != index) continue;
    const auto& uv = garment.triangle_uv[t];
    const Vec3 a = lifted(uv[0]), b = lifted(uv[1]), c = lifted(uv[2]);
    const Vec3 weights = geometry::closest_barycentric(lifted(place), a, b, c);
    const Vec3 point = weights[0] * a + weights[1] * b + weights[2] * c;
    if (const double d = (point - lifted(place)).norm(); d < distance) {
      distance = d;
      nearest = point;
      best = {t, weights};
    }
  }
  if (!(distance <= kEdgeSlack))
    throw InvalidInput(InputPlace{"", 0, "at"},
                       place_text(place) + ", " + fmt::format("{:.0f}", 1000 * distance) +
                           " mm outside panel " + panel,
                       "a place in it; the nearest is " + place_text(nearest.head<2>()));
  return best;
}

GarmentOverSkin::GarmentOverSkin(const garment::Garment& garment,
                                 const std::vector<Vec3>& positions, body::PosedBody body,
                                 const maps::WornGarment& worn)
    : garment_(garment),
      positions_(positions),
      body_(std::move(body)),
      worn_(worn),
      neighbours_(triangle_neighbours(garment)) {}

body::BodyPartner GarmentOverSkin::under(const GarmentPoint& point) const {
  return body_.partners().find(at(garment_, point, positions_),
                               at(garment_, point, worn_.normals).normalized(),
                               worn_.panel_part[garment_.triangle_panel[point.triangle]]);
}

GarmentPoint GarmentOverSkin::over_by_vertices(const Vec3& target, const Vec3& skin,
                                               const Vec3& normal, bool facing) const {
  struct Candidate {
    GarmentPoint point;
    double miss, gap;
  };
  std::vector<Candidate> near;
  double least = std::numeric_limits<double>::infinity();
  for (int t = 0; t < static_cast<int>(garment_.triangles.size()); ++t) {
    const Triangle& v = garment_.triangles[t];
    const auto partner = [&](int k) -> const Vec3& { return worn_.partners[v[k]].exact.point; };
    const Vec3 low = partner(0).cwiseMin(partner(1)).cwiseMin(partner(2)),
               high = partner(0).cwiseMax(partner(1)).cwiseMax(partner(2));
    if ((target - target.cwiseMax(low).cwiseMin(high)).norm() > least + kSameMiss) continue;
    if (facing && geometry::triangle_normal(positions_[v[0]], positions_[v[1]], positions_[v[2]])
                          .dot(normal) <= 0)
      continue;
    const Vec3 w = geometry::closest_barycentric(target, partner(0), partner(1), partner(2));
    const double miss = (w[0] * partner(0) + w[1] * partner(1) + w[2] * partner(2) - target).norm();
    if (miss > least + kSameMiss) continue;
    least = std::min(least, miss);
    const GarmentPoint point{t, w};
    near.push_back({point, miss, (at(garment_, point, positions_) - skin).norm()});
  }
  GarmentPoint best;
  double gap = std::numeric_limits<double>::infinity();
  for (const Candidate& c : near)
    if (c.miss <= least + kSameMiss && c.gap < gap - 1e-9) best = c.point, gap = c.gap;
  return best;
}

bool GarmentOverSkin::at_free_edge(const GarmentPoint& point) const {
  for (int k = 0; k < 3; ++k)
    if (neighbours_[point.triangle][k] < 0 && point.barycentric[(k + 2) % 3] < 1e-9) return true;
  return false;
}

GarmentOverSkin::Over GarmentOverSkin::over(const geometry::ClosestPoint& skin) const {
  // The skin's normal says from which side cloth has to lie over it.
  const Triangle& face = body_->surface.triangles[skin.triangle];
  Vec3 normal = Vec3::Zero();
  for (int k = 0; k < 3; ++k) normal += skin.barycentric[k] * body_->normals[face[k]];
  // Fixed-point iteration: aim at a target, see which skin lies under the cloth found there, and
  // shift the target by what was missed.
  Over best;
  best.miss = std::numeric_limits<double>::infinity();
  bool facing = true;
  Vec3 target = skin.point;
  for (int round = 0; round < kRounds && best.miss > kCloseEnough; ++round) {
    GarmentPoint point = over_by_vertices(target, skin.point, normal, facing);
    // No cloth faces that way: take cloth that is turned over, and say so.
    if (point.triangle < 0) {
      facing = false;
      point = over_by_vertices(target, skin.point, normal, facing);
    }
    const Vec3 missed = skin.point - under(point).exact.point;
    if (missed.norm() >= best.miss) break;
    best.point = point;
    best.miss = missed.norm();
    target += missed;
  }
  // Cloth lies over the place when the miss is small, or a little larger away from free edges where
  // a ray from the skin meets cloth.
  const double gap = (at(garment_, best.point, positions_) - skin.point).norm();
  const bool over =
      best.miss <= kNearMiss || (best.miss <= kInnerMiss && !at_free_edge(best.point) &&
                                 is_below_cloth(skin.point, normal.normalized()));
  if (!over)
    best.why_not = fmt::format("the garment ends {:.0f} mm away from it", 1e3 * best.miss);
  else if (gap > kCoverReach)
    best.why_not = far_off(gap);
  else if (!facing)
    best.why_not = "only cloth that is turned over lies there";
  best.covered = best.why_not.empty();
  return best;
}

bool GarmentOverSkin::is_below_cloth(const Vec3& skin, const Vec3& normal) const {
  const auto above = ray_crossings({positions_, garment_.triangles}, skin, normal);
  return std::any_of(above.begin(), above.end(),
                     [](const RayCrossing& c) { return c.distance <= kCoverReach; });
}

std::string off_skin(const garment::Garment& garment, const std::vector<Vec3>& positions,
                     const maps::WornGarment& worn, const GarmentPoint& point) {
  Vec3 skin = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
    skin += point.barycentric[k] * worn.partners[garment.triangles[point.triangle][k]].exact.point;
  const double gap = (at(garment, point, positions) - skin).norm();
  return gap > kCoverReach ? far_off(gap) : std::string();
}

double angle_in_pattern(const garment::Garment& garment, const std::vector<Vec3>& positions,
                        const std::vector<int>& triangles, const Vec3& axis) {
  Vec2 sum = Vec2::Zero();
  for (int t : triangles) {
    if (garment.triangle_panel[t] != garment.triangle_panel[triangles.front()]) continue;
    const auto& uv = garment.triangle_uv[t];
    const double twice_area = std::abs(geometry::cross(uv[1] - uv[0], uv[2] - uv[0]));
    if (twice_area < 1e-16) continue;
    const geometry::DeformationGradient gradient =
        geometry::deformation_gradient(uv, garment.triangles[t], positions);
    const Mat2 metric = gradient.transpose() * gradient;
    if (std::abs(metric.determinant()) < 1e-12) continue;
    sum += twice_area * (metric.inverse() * (gradient.transpose() * axis));
  }
  if (!(sum.norm() > 1e-12)) return std::numeric_limits<double>::quiet_NaN();
  return std::atan2(-sum.x(), sum.y());
}

}  // namespace loosefit::placement
