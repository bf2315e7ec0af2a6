#include "loosefit/geometry/exact_intersection.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>

#include "loosefit/geometry/box_pairs.h"

namespace loosefit {
namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Segment = Kernel::Segment_3;
using Triangle3 = Kernel::Triangle_3;

Point point(const Vec3& p) { return {p[0], p[1], p[2]}; }

/// Longest side of a triangle whose corners are collinear.
Segment longest_side(const Triangle3& t) {
  Segment best(t[0], t[1]);
  for (int k = 1; k < 3; ++k) {
    const Segment side(t[k], t[(k + 1) % 3]);
    if (side.squared_length() > best.squared_length()) best = side;
  }
  return best;
}

bool intersect(const Segment& s, const Triangle3& t) {
  if (t.is_degenerate()) {
    const Segment u = longest_side(t);
    if (s.is_degenerate()) return u.is_degenerate() ? s[0] == u[0] : u.has_on(s[0]);
    return u.is_degenerate() ? s.has_on(u[0]) : CGAL::do_intersect(s, u);
  }
  if (s.is_degenerate()) return t.has_on(s[0]);
  return CGAL::do_intersect(s, t);
}

bool intersect(const Triangle3& a, const Triangle3& b) {
  if (a.is_degenerate()) return intersect(longest_side(a), b);
  if (b.is_degenerate()) return intersect(longest_side(b), a);
  return CGAL::do_intersect(a, b);
}

Triangle3 triangle(const std::vector<Vec3>& x, const Triangle& t) {
  return {point(x[t[0]]), point(x[t[1]]), point(x[t[2]])};
}

std::vector<Box3> boxes_of(const std::vector<Vec3>& x, const std::vector<Triangle>& triangles) {
  std::vector<Box3> boxes(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (int v : triangles[i]) boxes[i].extend(x[v]);
  return boxes;
}

/// Side of a triangle opposite to the corner with vertex index `vertex`.
Segment far_side(const std::vector<Vec3>& x, const Triangle& t, int vertex) {
  const int k = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
  return {point(x[t[(k + 1) % 3]]), point(x[t[(k + 2) % 3]])};
}

}  // namespace

std::vector<std::pair<int, int>> self_intersections(const std::vector<Vec3>& vertices,
                                                    const std::vector<Triangle>& triangles) {
  std::vector<std::pair<int, int>> hits;
  for (const auto& [i, j] : overlapping_boxes(boxes_of(vertices, triangles))) {
    const Triangle &a = triangles[i], &b = triangles[j];
    int shared = 0, vertex = -1;
    for (int v : a)
      if (std::find(b.begin(), b.end(), v) != b.end()) {
        ++shared;
        vertex = v;
      }
    if (shared >= 2) continue;
    bool hit;
    if (shared == 1)
      hit = intersect(far_side(vertices, a, vertex), triangle(vertices, b)) ||
            intersect(far_side(vertices, b, vertex), triangle(vertices, a));
    else
      hit = intersect(triangle(vertices, a), triangle(vertices, b));
    if (hit) hits.emplace_back(i, j);
  }
  return hits;
}

std::vector<std::pair<int, int>> mesh_intersections(const std::vector<Vec3>& a_vertices,
                                                    const std::vector<Triangle>& a_triangles,
                                                    const std::vector<Vec3>& b_vertices,
                                                    const std::vector<Triangle>& b_triangles) {
  std::vector<std::pair<int, int>> hits;
  for (const auto& [i, j] :
       overlapping_boxes(boxes_of(a_vertices, a_triangles), boxes_of(b_vertices, b_triangles)))
    if (intersect(triangle(a_vertices, a_triangles[i]), triangle(b_vertices, b_triangles[j])))
      hits.emplace_back(i, j);
  return hits;
}

}  // namespace loosefit
