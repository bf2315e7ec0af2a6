#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::io {

/// Surface of an OBJ file: its v and f lines. Corner forms are 7, 7/1, 7/1/3 and 7//3; a negative
/// index counts back from the latest vertex. `path` is for messages only. \throws InvalidInput
/// naming file, line and what was expected.
geometry::TriangleMesh parse_obj(std::string_view text, const std::string& path);

/// Writes an OBJ (metres, our axes) with normals when given. \throws IoError.
void write_obj(const std::string& path, const geometry::TriangleMesh& mesh,
               const std::vector<Vec3>& normals = {});

}  // namespace loosefit::io
