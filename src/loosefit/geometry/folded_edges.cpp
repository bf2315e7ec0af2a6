#include "loosefit/geometry/folded_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "loosefit/geometry/mesh_topology.h"

namespace loosefit::geometry {

std::vector<std::pair<int, int>> folded_edges(const std::vector<Vec3>& vertices,
                                              const std::vector<Triangle>& triangles) {
  const MeshTopology topology(triangles);
  std::vector<std::pair<int, int>> folded;
  for (int e = 0; e < topology.edge_count(); ++e) {
    const auto sides = topology.sides(e);
    const Vec3& origin = vertices[topology.edges()[e][0]];
    const Vec3 along = (vertices[topology.edges()[e][1]] - origin).normalized();
    // From the edge towards the free corner, at right angles to the edge.
    const auto height = [&](const MeshTopology::Side& side) -> Vec3 {
      const Vec3 corner = vertices[triangles[side.triangle][(side.corner + 2) % 3]] - origin;
      return corner - along * along.dot(corner);
    };
    for (std::size_t a = 0; a < sides.size(); ++a)
      for (std::size_t b = a + 1; b < sides.size(); ++b) {
        const Vec3 p = height(sides[a]), q = height(sides[b]);
        // atan2 keeps its digits near 0, where the cosine loses them.
        const double between = std::atan2(p.cross(q).norm(), p.dot(q));
        const double farther = std::max(p.norm(), q.norm()) * std::sin(between);
        if (p.norm() * q.norm() > 0 && between < kFoldedAngle && farther < kFoldedDistance)
          folded.emplace_back(sides[a].triangle, sides[b].triangle);
      }
  }
  return folded;
}

}  // namespace loosefit::geometry
