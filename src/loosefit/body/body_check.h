#pragma once
#include <string>
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit {

/// What the user knows of a scanned surface; empty texts are inferred with a warning.
struct ScanOptions {
  std::string file;   ///< for messages
  std::string units;  ///< "m", "cm", "mm", "in" or empty
  std::string up;     ///< "z", "y" or empty
};

/// A surface fit to be a body: metres, z up, facing -y, closed, outward, one piece, floor at z = 0,
/// trunk over the origin.
struct CheckedSurface {
  TriangleMesh mesh;
  std::vector<std::string> warnings;
};

/// Welds, scales, turns, keeps the largest piece, orients and checks a scan.
/// \throws GeometryError when it is open, not orientable or not manifold (says where);
/// InvalidInput when no unit makes it a person.
CheckedSurface check_surface(TriangleMesh mesh, const ScanOptions& options);

}  // namespace loosefit
