#pragma once
#include <utility>
#include <vector>

#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::geometry {

/// Penetrations: pairs (i, j), i < j, of triangles of one surface that intersect; decided with
/// exact predicates (CGAL, Exact_predicates_inexact_constructions_kernel). Triangles that share an
/// edge are not tested; triangles that share one vertex count when the far edge of one meets the
/// other. Degenerate triangles are tested as the segment they are. \throws nothing.
std::vector<std::pair<int, int>> self_intersections(const std::vector<Vec3>& vertices,
                                                    const std::vector<Triangle>& triangles);

/// Those of them with a triangle, or two, for which `wanted` is set: after a part of a surface has
/// moved, the others are as they were.
std::vector<std::pair<int, int>> self_intersections(const std::vector<Vec3>& vertices,
                                                    const std::vector<Triangle>& triangles,
                                                    const std::vector<char>& wanted);

/// Pairs (triangle of a, triangle of b) that intersect, touching included; exact predicates.
std::vector<std::pair<int, int>> mesh_intersections(const std::vector<Vec3>& a_vertices,
                                                    const std::vector<Triangle>& a_triangles,
                                                    const std::vector<Vec3>& b_vertices,
                                                    const std::vector<Triangle>& b_triangles);

/// The same with the surface of a tree that is there already.
std::vector<std::pair<int, int>> mesh_intersections(const std::vector<Vec3>& a_vertices,
                                                    const std::vector<Triangle>& a_triangles,
                                                    const ClosestPointTree& b);

}  // namespace loosefit::geometry
