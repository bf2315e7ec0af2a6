#pragma once
#include <array>
#include <utility>
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::body {

/// One Catmull-Clark step of a closed quad mesh as a fixed linear map (Catmull and Clark 1978).
/// Fine vertices: vertex points first (old vertices keep their index), then edge points, then face
/// points. A mirror-symmetric quad mesh gives a mirror-symmetric triangulation.
class CatmullClark {
 public:
  /// \throws GeometryError unless every edge has exactly two faces, in opposite directions.
  CatmullClark(int vertex_count, const std::vector<std::array<int, 4>>& quads);

  int fine_vertex_count() const { return int(start_.size()) - 1; }
  const std::vector<Triangle>& fine_triangles() const { return triangles_; }
  /// Fine positions from the first `vertex_count` entries of `coarse`.
  std::vector<Vec3> refine(const std::vector<Vec3>& coarse) const;
  /// Coarse vertices and weights (sum 1) a fine vertex is made of.
  std::vector<std::pair<int, double>> stencil(int fine_vertex) const;

 private:
  std::vector<int> start_;  ///< per fine vertex: first entry in index_ and weight_
  std::vector<int> index_;
  std::vector<double> weight_;
  std::vector<Triangle> triangles_;
};

/// The coarse quads as triangles 0-1-2 and 0-2-3.
std::vector<Triangle> triangulate(const std::vector<std::array<int, 4>>& quads);

}  // namespace loosefit::body
