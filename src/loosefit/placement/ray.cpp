#include "loosefit/placement/ray.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace loosefit::placement {
namespace {
// A ray along the mesh's plane of symmetry runs through edges and must not slip between triangles.
constexpr double kSlack = 1e-9;
constexpr double kBoxSlack = 1e-7;  ///< more than kSlack times any edge [m]

/// The surface seen along a ray, which is a point then: what does not cover it is quickly told.
class SeenAlong {
 public:
  SeenAlong(const geometry::TriangleMesh& surface, const Vec3& origin, const Vec3& direction)
      : at_(surface.vertices.size()) {
    const Vec3 across = direction.unitOrthogonal(), other = direction.cross(across).normalized();
    for (std::size_t i = 0; i < at_.size(); ++i) {
      const Vec3 from = surface.vertices[i] - origin;
      at_[i] = {from.dot(across), from.dot(other)};
    }
  }
  bool may_cover_ray(const Triangle& t) const {
    for (int k = 0; k < 2; ++k) {
      const double a = at_[t[0]][k], b = at_[t[1]][k], c = at_[t[2]][k];
      if (std::min({a, b, c}) > kBoxSlack || std::max({a, b, c}) < -kBoxSlack) return false;
    }
    return true;
  }

 private:
  std::vector<Vec2> at_;
};
}  // namespace

std::vector<RayCrossing> ray_crossings(const geometry::TriangleMesh& surface, const Vec3& origin,
                                       const Vec3& direction,
                                       const std::function<bool(int)>& accept) {
  std::vector<RayCrossing> found;
  // Only triangles whose box round the ray covers it are intersected.
  const SeenAlong seen(surface, origin, direction);
  for (int i = 0; i < static_cast<int>(surface.triangles.size()); ++i) {
    const Triangle& t = surface.triangles[i];
    if (!seen.may_cover_ray(t)) continue;
    const Vec3 &a = surface.vertices[t[0]], ab = surface.vertices[t[1]] - a,
               ac = surface.vertices[t[2]] - a;
    // Barycentric coordinates of the crossing, with slack so that a ray
    // through an edge is not lost.
    const Vec3 normal = ab.cross(ac);
    const double along = normal.dot(direction);
    if (along == 0) continue;
    const Vec3 from = origin - a, cross = from.cross(direction);
    const double u = -cross.dot(ac) / along, v = cross.dot(ab) / along;
    if (u < -kSlack || v < -kSlack || u + v > 1 + kSlack) continue;
    const double distance = -normal.dot(from) / along;
    if (distance < 0 || (accept && !accept(i))) continue;
    found.push_back({i, Vec3(1 - u - v, u, v), origin + distance * direction, distance, along > 0});
  }
  return found;
}

std::optional<Vec3> ray_exit(const geometry::TriangleMesh& surface, const Vec3& origin,
                             const Vec3& direction) {
  std::optional<RayCrossing> nearest;
  for (const RayCrossing& crossing : ray_crossings(surface, origin, direction))
    if (crossing.leaving && (!nearest || crossing.distance < nearest->distance)) nearest = crossing;
  if (!nearest) return std::nullopt;
  return nearest->point;
}

}  // namespace loosefit::placement
