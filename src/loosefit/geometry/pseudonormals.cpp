#include "loosefit/geometry/pseudonormals.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <cmath>

#include "loosefit/geometry/mesh_topology.h"

namespace loosefit::geometry {
Pseudonormals::Pseudonormals(const TriangleMesh& mesh)
    : of_vertex_(mesh.vertices.size(), Vec3::Zero()), of_edge_(mesh.triangles.size()) {
  const std::size_t n = mesh.triangles.size();
  std::vector<Vec3> normals(n);
  std::vector<std::array<double, 3>> angles(n);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, 1024), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const Triangle& t = mesh.triangles[i];
      const Vec3 p[3] = {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
      normals[i] = triangle_normal(p[0], p[1], p[2]);
      for (int k = 0; k < 3; ++k) {
        const Vec3 e1 = p[(k + 1) % 3] - p[k], e2 = p[(k + 2) % 3] - p[k];
        angles[i][k] = std::atan2(e1.cross(e2).norm(), e1.dot(e2));
      }
    }
  });
  for (std::size_t i = 0; i < n; ++i)
    for (int k = 0; k < 3; ++k) of_vertex_[mesh.triangles[i][k]] += angles[i][k] * normals[i];
  const MeshTopology topology(mesh.triangles);
  for (int e = 0; e < topology.edge_count(); ++e) {
    Vec3 sum = Vec3::Zero();
    for (const auto& side : topology.sides(e)) sum += normals[side.triangle];
    for (const auto& side : topology.sides(e)) of_edge_[side.triangle][side.corner] = sum;
  }
}

Vec3 Pseudonormals::at(const TriangleMesh& mesh, const ClosestPoint& closest) const {
  const Triangle& t = mesh.triangles[closest.triangle];
  const Vec3& b = closest.barycentric;
  const int zeros = (b[0] <= 0) + (b[1] <= 0) + (b[2] <= 0);
  if (zeros == 2) {
    int corner = 0;
    b.maxCoeff(&corner);
    return of_vertex_[t[corner]];
  }
  if (zeros == 1) {
    int opposite = 0;
    b.minCoeff(&opposite);
    return of_edge_[closest.triangle][(opposite + 1) % 3];
  }
  return triangle_normal(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
}

}  // namespace loosefit::geometry
