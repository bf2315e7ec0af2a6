#include "loosefit/placement/ray.h"

#include <Eigen/Geometry>
#include <limits>

namespace loosefit {
namespace {
// A ray along the mesh's plane of symmetry runs through edges and must not slip between triangles.
constexpr double kSlack = 1e-9;
}  // namespace

std::optional<Vec3> ray_exit(const TriangleMesh& surface, const Vec3& origin,
                             const Vec3& direction) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Triangle& t : surface.triangles) {
    const Vec3 &a = surface.vertices[t[0]], ab = surface.vertices[t[1]] - a,
               ac = surface.vertices[t[2]] - a;
    const Vec3 normal = ab.cross(ac);
    const double along = normal.dot(direction);
    if (along <= 0) continue;  // entering or grazing
    const Vec3 from = origin - a, cross = from.cross(direction);
    const double u = cross.dot(ac) / along, v = -cross.dot(ab) / along;
    if (u < -kSlack || v < -kSlack || u + v > 1 + kSlack) continue;
    const double distance = -normal.dot(from) / along;
    if (distance > 0 && distance < nearest) nearest = distance;
  }
  if (nearest == std::numeric_limits<double>::infinity()) return std::nullopt;
  return origin + nearest * direction;
}

}  // namespace loosefit
