#pragma once
#include <string>
#include <string_view>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::io {

/// Surface of an STL file, ascii or binary; corners at one place become one vertex. `path` is for
/// messages only. \throws InvalidInput naming file, line or triangle, and what was expected.
geometry::TriangleMesh parse_stl(std::string_view bytes, const std::string& path);

}  // namespace loosefit::io
