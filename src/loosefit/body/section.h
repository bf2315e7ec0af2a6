#pragma once
#include <array>
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::body {

/// A closed curve where a plane cuts a surface.
struct SectionLoop {
  std::vector<Vec3> points;               ///< in order; the last point joins the first
  std::vector<std::array<int, 2>> edges;  ///< mesh edge on which each point lies
  double length = 0;                      ///< perimeter [m]
};

/// All closed loops along which a scalar per vertex has this value; rules as of plane_section.
std::vector<SectionLoop> level_section(const geometry::TriangleMesh& mesh,
                                       const std::vector<double>& values, double level);

/// All closed loops of the cut by the plane through `origin` with normal `normal`. A vertex exactly
/// on the plane counts as lying above it, so every loop of a closed surface closes. Loops are in
/// the order of their first triangle; open chains of an open surface are left out (open_chains).
std::vector<SectionLoop> plane_section(const geometry::TriangleMesh& mesh, const Vec3& origin,
                                       const Vec3& normal);

/// The curves of the same cut that end at the border of an open surface, from end to end: their
/// last point does not join the first. In the order of the first triangle at an end of them.
std::vector<SectionLoop> open_chains(const geometry::TriangleMesh& mesh, const Vec3& origin,
                                     const Vec3& normal);

/// Middle of the curve, weighted by length.
Vec3 centroid(const SectionLoop& loop);

/// True when the polygon of the loop, seen along `normal`, contains `point`.
bool loop_contains(const SectionLoop& loop, const Vec3& normal, const Vec3& point);

/// Perimeter of the convex hull of points seen along `normal`: what a tape measures [m].
double hull_perimeter(const std::vector<Vec3>& points, const Vec3& normal);

/// Convex hull of plane points, counter-clockwise, no repeated end (Andrew 1979).
std::vector<Vec2> convex_hull(std::vector<Vec2> points);

/// The loop around the trunk: the longest whose x-range contains `x`. Null when there is none.
const SectionLoop* trunk_loop(const std::vector<SectionLoop>& loops, double x = 0);

}  // namespace loosefit::body
