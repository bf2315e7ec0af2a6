#include "loosefit/geometry/convex_hull.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace loosefit::geometry {
namespace {

/// The same surface with vertices in lexicographic order, triangles that begin at their first
/// vertex, and triangles in order.
TriangleMesh in_order(const TriangleMesh& mesh) {
  const auto before = [&](int a, int b) {
    const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b];
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
  };
  std::vector<int> old(mesh.vertices.size()), now(old.size());
  std::iota(old.begin(), old.end(), 0);
  std::sort(old.begin(), old.end(), before);
  TriangleMesh ordered;
  for (std::size_t i = 0; i < old.size(); ++i) {
    now[old[i]] = static_cast<int>(i);
    ordered.vertices.push_back(mesh.vertices[old[i]]);
  }
  for (Triangle t : mesh.triangles) {
    for (int& v : t) v = now[v];
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    ordered.triangles.push_back(t);
  }
  std::sort(ordered.triangles.begin(), ordered.triangles.end());
  return ordered;
}

}  // namespace

TriangleMesh convex_hull(const std::vector<Vec3>& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> all;
  for (const Vec3& p : points) all.emplace_back(p[0], p[1], p[2]);
  CGAL::Surface_mesh<Kernel::Point_3> hull;
  CGAL::convex_hull_3(all.begin(), all.end(), hull);
  TriangleMesh mesh;
  if (hull.is_empty() || !CGAL::is_closed(hull)) return mesh;
  for (const auto v : hull.vertices()) {
    const auto& p = hull.point(v);
    mesh.vertices.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto f : hull.faces()) {
    Triangle t;
    int k = 0;
    for (const auto v : hull.vertices_around_face(hull.halfedge(f))) t[k++] = static_cast<int>(v);
    mesh.triangles.push_back(t);
  }
  // CGAL goes round the horizon in the order of addresses in memory, which no run repeats.
  return in_order(mesh);
}

}  // namespace loosefit::geometry
