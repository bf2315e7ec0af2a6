#include "loosefit/geometry/exact_intersection.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "loosefit/geometry/box_pairs.h"

namespace loosefit::geometry {
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

/// Whether the corners of `other`, but for `skipped`, all lie on one side of the plane, by more
/// than round-off: a quick no for nearly all pairs, where the exact predicates take several times
/// as long.
bool parted_by_plane(const std::vector<Vec3>& x, const Triangle& plane, const Triangle& other,
                     int skipped) {
  constexpr double kRounding = 1e-14;  // relative; the sums below are off by some 20 units of 1e-16
  constexpr double kSmallest = 1e-290;  // well above numbers that lose digits by being small
  const Vec3 &a = x[plane[0]], ab = x[plane[1]] - a, ac = x[plane[2]] - a, normal = ab.cross(ac);
  const double size = kRounding * ab.norm() * ac.norm();
  bool above = true, below = true;
  for (int v : other) {
    if (v == skipped) continue;
    const Vec3 from = x[v] - a;
    const double height = normal.dot(from), error = size * from.norm() + kSmallest;
    above &= height > error;
    below &= height < -error;
  }
  return above || below;
}

Box3 box_of(const std::vector<Vec3>& x, const Triangle& t) {
  Box3 box;
  for (int v : t) box.extend(x[v]);
  return box;
}

std::vector<Box3> boxes_of(const std::vector<Vec3>& x, const std::vector<Triangle>& triangles) {
  std::vector<Box3> boxes;
  boxes.reserve(triangles.size());
  for (const Triangle& t : triangles) boxes.push_back(box_of(x, t));
  return boxes;
}

/// Side of a triangle opposite to the corner with vertex index `vertex`.
Segment far_side(const std::vector<Vec3>& x, const Triangle& t, int vertex) {
  const int k = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
  return {point(x[t[(k + 1) % 3]]), point(x[t[(k + 2) % 3]])};
}

/// Whether two triangles of one surface intersect, as self_intersections counts them.
bool cut_each_other(const std::vector<Vec3>& x, const Triangle& a, const Triangle& b) {
  int shared = 0, vertex = -1;
  for (int v : a)
    if (std::find(b.begin(), b.end(), v) != b.end()) {
      ++shared;
      vertex = v;
    }
  if (shared >= 2) return false;
  const bool by_a = parted_by_plane(x, a, b, vertex), by_b = parted_by_plane(x, b, a, vertex);
  if (shared == 1)
    return (!by_b && intersect(far_side(x, a, vertex), triangle(x, b))) ||
           (!by_a && intersect(far_side(x, b, vertex), triangle(x, a)));
  return !by_a && !by_b && intersect(triangle(x, a), triangle(x, b));
}

/// The pairs that are wanted, asked in parallel, in their order.
template <class Wanted>
std::vector<std::pair<int, int>> selected(const std::vector<std::pair<int, int>>& pairs,
                                          const Wanted& wanted) {
  std::vector<char> hit(pairs.size());
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, pairs.size(), 256), [&](const Range& range) {
    for (std::size_t k = range.begin(); k < range.end(); ++k)
      hit[k] = wanted(pairs[k].first, pairs[k].second);
  });
  std::vector<std::pair<int, int>> hits;
  for (std::size_t k = 0; k < pairs.size(); ++k)
    if (hit[k]) hits.push_back(pairs[k]);
  return hits;
}

}  // namespace

std::vector<std::pair<int, int>> self_intersections(const std::vector<Vec3>& vertices,
                                                    const std::vector<Triangle>& triangles) {
  return selected(overlapping_boxes(boxes_of(vertices, triangles)), [&](int i, int j) {
    return cut_each_other(vertices, triangles[i], triangles[j]);
  });
}

std::vector<std::pair<int, int>> self_intersections(const std::vector<Vec3>& vertices,
                                                    const std::vector<Triangle>& triangles,
                                                    const std::vector<char>& wanted) {
  const std::vector<Box3> boxes = boxes_of(vertices, triangles);
  std::vector<Box3> some;
  std::vector<int> number;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (wanted[t]) {
      some.push_back(boxes[t]);
      number.push_back(static_cast<int>(t));
    }
  std::vector<std::pair<int, int>> pairs;
  for (const auto& [s, j] : overlapping_boxes(some, boxes))
    if (const int i = number[s]; i < j || !wanted[j]) pairs.emplace_back(std::minmax(i, j));
  std::erase_if(pairs, [](const auto& pair) { return pair.first == pair.second; });
  std::sort(pairs.begin(), pairs.end());
  return selected(
      pairs, [&](int i, int j) { return cut_each_other(vertices, triangles[i], triangles[j]); });
}

std::vector<std::pair<int, int>> mesh_intersections(const std::vector<Vec3>& a_vertices,
                                                    const std::vector<Triangle>& a_triangles,
                                                    const std::vector<Vec3>& b_vertices,
                                                    const std::vector<Triangle>& b_triangles) {
  return selected(
      overlapping_boxes(boxes_of(a_vertices, a_triangles), boxes_of(b_vertices, b_triangles)),
      [&](int i, int j) {
        return intersect(triangle(a_vertices, a_triangles[i]),
                         triangle(b_vertices, b_triangles[j]));
      });
}

std::vector<std::pair<int, int>> mesh_intersections(const std::vector<Vec3>& a_vertices,
                                                    const std::vector<Triangle>& a_triangles,
                                                    const ClosestPointTree& b) {
  const TriangleMesh& surface = b.mesh();
  std::vector<std::vector<int>> hits(a_triangles.size());
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, a_triangles.size(), 64), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      hits[i] = b.overlapping(box_of(a_vertices, a_triangles[i]));
      std::erase_if(hits[i], [&](int j) {
        return !intersect(triangle(a_vertices, a_triangles[i]),
                          triangle(surface.vertices, surface.triangles[j]));
      });
    }
  });
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < hits.size(); ++i)
    for (int j : hits[i]) pairs.emplace_back(static_cast<int>(i), j);
  return pairs;
}

}  // namespace loosefit::geometry
