#pragma once
#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::geometry {

/// Surface of the convex hull of points, closed and oriented outwards (CGAL, quickhull). Empty when
/// all points lie in a plane. Vertices and triangles stand in an order that depends on the places
/// of the points alone, so that distances to the hull have the same bits in every run. \pre for
/// that, no four points of a facet lie in one plane
TriangleMesh convex_hull(const std::vector<Vec3>& points);

}  // namespace loosefit::geometry
