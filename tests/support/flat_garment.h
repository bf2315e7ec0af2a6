#pragma once
#include "support/shapes.h"

namespace loosefit::support {

/// Pattern coordinates of a mesh that lies flat in the (x, y) plane: u = x, v = y.
inline std::vector<std::array<Vec2, 3>> flat_uv(const geometry::TriangleMesh& mesh) {
  std::vector<std::array<Vec2, 3>> uv;
  for (const Triangle& t : mesh.triangles)
    uv.push_back({mesh.vertices[t[0]].head<2>(), mesh.vertices[t[1]].head<2>(),
                  mesh.vertices[t[2]].head<2>()});
  return uv;
}

/// Lumped masses [kg] of a flat mesh with areal density w [kg/m²].
inline std::vector<double> lumped_mass(const geometry::TriangleMesh& mesh, double w) {
  std::vector<double> m(mesh.vertices.size(), 0.0);
  for (const Triangle& t : mesh.triangles)
    for (int v : t)
      m[v] +=
          w / 3 *
          geometry::triangle_area(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
  return m;
}

}  // namespace loosefit::support
