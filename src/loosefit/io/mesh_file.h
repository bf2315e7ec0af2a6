#pragma once
#include <string>
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::io {

/// A surface as a file has it: file units and file axes, polygons cut into triangles.
struct MeshFile {
  geometry::TriangleMesh mesh;
  std::vector<std::string> warnings;  ///< what had to be repaired: corners welded, slivers dropped
  std::string units;  ///< "m", "cm", "mm" or "in", where a comment of the file states it
};

/// Reads OBJ, PLY (ascii, binary; strips of triangles too) or STL (ascii, binary) by what the file
/// holds; the extension only decides when the content does not. STL corners at one place become one
/// vertex. \throws IoError when unreadable; InvalidInput naming file, line (text) and what was
/// expected.
MeshFile read_mesh(const std::string& path);

}  // namespace loosefit::io
