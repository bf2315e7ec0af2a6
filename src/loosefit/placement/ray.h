#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::placement {

/// Where a ray passes a triangle.
struct RayCrossing {
  int triangle = -1;
  Vec3 barycentric = Vec3::Zero();
  Vec3 point = Vec3::Zero();
  double distance = 0;   ///< from the origin, in lengths of the direction; not negative
  bool leaving = false;  ///< passes the triangle from behind
};

/// All triangles that the ray from `origin` in `direction` passes and that `accept` admits (empty:
/// all), in order of their index (Möller and Trumbore 1997). Grazed triangles do not count; a
/// crossing on an edge is told once for each of its triangles.
std::vector<RayCrossing> ray_crossings(const geometry::TriangleMesh& surface, const Vec3& origin,
                                       const Vec3& direction,
                                       const std::function<bool(int)>& accept = {});

/// First point at which the ray leaves the surface; nothing if it never does.
std::optional<Vec3> ray_exit(const geometry::TriangleMesh& surface, const Vec3& origin,
                             const Vec3& direction);

}  // namespace loosefit::placement
