#pragma once
#include <array>
#include <vector>

#include "loosefit/geometry/closest_point.h"

namespace loosefit::geometry {

/// Normals of the faces, edges and corners of a closed, outward oriented surface that tell on which
/// side of it a point lies: angle-weighted at corners (Bærentzen and Aanæs 2005).
class Pseudonormals {
 public:
  explicit Pseudonormals(const TriangleMesh& mesh);
  /// Of the face, edge or corner that the closest point lies on; not of length 1.
  Vec3 at(const TriangleMesh& mesh, const ClosestPoint& closest) const;

 private:
  std::vector<Vec3> of_vertex_;
  std::vector<std::array<Vec3, 3>> of_edge_;  ///< per triangle, edge i = corner i → i + 1
};

}  // namespace loosefit::geometry
