#pragma once
#include <optional>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit {

/// First point at which the ray from `origin` in `direction` leaves the surface (passes a triangle
/// from behind); nothing if it never does. Möller and Trumbore 1997, over all triangles.
std::optional<Vec3> ray_exit(const TriangleMesh& surface, const Vec3& origin,
                             const Vec3& direction);

}  // namespace loosefit
