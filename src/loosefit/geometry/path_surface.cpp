#include "loosefit/geometry/path_surface.h"

#include <algorithm>
#include <cmath>

namespace loosefit::geometry {
namespace {

/// Mean over the triangles at each edge of what `side` says of its length there.
template <class Side>
std::vector<double> edge_lengths(const MeshTopology& topology, const Side& side) {
  std::vector<double> lengths;
  for (int e = 0; e < topology.edge_count(); ++e) {
    double sum = 0;
    for (const MeshTopology::Side& at : topology.sides(e)) sum += side(at.triangle, at.corner);
    lengths.push_back(sum / static_cast<double>(topology.sides(e).size()));
  }
  return lengths;
}

}  // namespace

PathSurface::PathSurface(const TriangleMesh& mesh)
    : triangles_(mesh.triangles), topology_(mesh.triangles) {
  length_ = edge_lengths(topology_, [&](int t, int k) {
    const Triangle& v = triangles_[t];
    return (mesh.vertices[v[(k + 1) % 3]] - mesh.vertices[v[k]]).norm();
  });
  lay_flat();
}

PathSurface::PathSurface(std::vector<Triangle> triangles, const std::vector<FlatCorners>& flat)
    : triangles_(std::move(triangles)), topology_(triangles_) {
  length_ = edge_lengths(topology_,
                         [&](int t, int k) { return (flat[t][(k + 1) % 3] - flat[t][k]).norm(); });
  lay_flat();
}

void PathSurface::lay_flat() {
  for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
    const double a = length_[topology_.edge(t, 0)], b = length_[topology_.edge(t, 1)],
                 c = length_[topology_.edge(t, 2)];
    // The third corner from the law of cosines.
    const double x = a > 0 ? (a * a + c * c - b * b) / (2 * a) : 0;
    flat_.push_back({Vec2(0, 0), Vec2(a, 0), Vec2(x, std::sqrt(std::max(0.0, c * c - x * x)))});
  }
}

double PathSurface::length(const PathPiece& piece) const {
  const FlatCorners& corner = flat_[piece.triangle];
  const Vec3 way = piece.to - piece.from;
  return (way[0] * corner[0] + way[1] * corner[1] + way[2] * corner[2]).norm();
}

double PathSurface::length(const SurfacePath& path) const {
  double sum = 0;
  for (const PathPiece& piece : path) sum += length(piece);
  return sum;
}

}  // namespace loosefit::geometry
