#pragma once
#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::geometry {

/// Surface of the convex hull of points, closed and oriented outwards (CGAL, quickhull). Empty when
/// all points lie in a plane.
TriangleMesh convex_hull(const std::vector<Vec3>& points);

}  // namespace loosefit::geometry
