#pragma once
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::io {

/// Adds a polygon of a surface file as a fan of triangles about its first corner.
inline void add_polygon(const std::vector<int>& corners, geometry::TriangleMesh& mesh) {
  for (std::size_t i = 2; i < corners.size(); ++i)
    mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

}  // namespace loosefit::io
