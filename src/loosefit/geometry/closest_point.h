#pragma once
#include <limits>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::geometry {

/// Closest point on a triangle (Ericson 2005, Real-Time Collision Detection, 5.1.5).
/// Returns barycentric weights of (a, b, c); they sum to 1 and are ≥ 0.
Vec3 closest_barycentric(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// Answer of a closest-point query. `triangle` is -1 when nothing lies within the search radius.
struct ClosestPoint {
  int triangle = -1;
  Vec3 barycentric = Vec3::Zero();
  Vec3 point = Vec3::Zero();
  double distance = std::numeric_limits<double>::infinity();  ///< unsigned [m]
};

/// Looks at every triangle: the oracle of ClosestPointTree's tests.
ClosestPoint closest_point_brute_force(const TriangleMesh& mesh, const Vec3& p);

}  // namespace loosefit::geometry
