#include "loosefit/geometry/convex_hull.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/convex_hull_3.h>

namespace loosefit::geometry {

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
  return mesh;
}

}  // namespace loosefit::geometry
