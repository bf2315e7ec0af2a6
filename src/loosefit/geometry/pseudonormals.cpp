#include "loosefit/geometry/pseudonormals.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <compare>

namespace loosefit {
namespace {

/// From one corner of a triangle to the next, kept with the lower numbered of the two vertices.
struct HalfEdge {
  int other;  ///< vertex
  int triangle, corner;
  auto operator<=>(const HalfEdge&) const = default;
};

/// Half edges by their lower vertex.
struct EdgeLists {
  std::vector<int> start;
  std::vector<HalfEdge> half_edges;

  explicit EdgeLists(const TriangleMesh& mesh)
      : start(mesh.vertices.size() + 1, 0), half_edges(3 * mesh.triangles.size()) {
    for (const Triangle& t : mesh.triangles)
      for (int k = 0; k < 3; ++k) ++start[std::min(t[k], t[(k + 1) % 3]) + 1];
    for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
    std::vector<int> next(start.begin(), start.end() - 1);
    for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i)
      for (int k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(mesh.triangles[i][k], mesh.triangles[i][(k + 1) % 3]);
        half_edges[next[low]++] = {high, i, k};
      }
  }
};

}  // namespace

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
  EdgeLists edges(mesh);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const auto begin = edges.half_edges.begin() + edges.start[v],
               end = edges.half_edges.begin() + edges.start[v + 1];
    std::sort(begin, end);
    for (auto first = begin, last = begin; first != end; first = last) {
      Vec3 sum = Vec3::Zero();
      for (; last != end && last->other == first->other; ++last) sum += normals[last->triangle];
      for (auto edge = first; edge != last; ++edge) of_edge_[edge->triangle][edge->corner] = sum;
    }
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

}  // namespace loosefit
