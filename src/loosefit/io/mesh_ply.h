#pragma once
#include <string>
#include <string_view>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::io {

/// Surface of a PLY file, ascii or binary of either byte order: x, y, z of its vertices and
/// vertex_indices (or vertex_index) of its faces. `path` is for messages only. \throws InvalidInput
/// naming file, line and what was expected.
geometry::TriangleMesh parse_ply(std::string_view bytes, const std::string& path);

}  // namespace loosefit::io
