#pragma once
#include <string>
#include <vector>

#include "loosefit/body/scan_frame.h"
#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::body {

/// A surface fit to be a body: metres, z up, facing -y, closed, outward, one piece, floor at z = 0,
/// trunk over the origin. With ScanOptions::take_parts and more than one piece: neither one
/// piece nor closed.
struct CheckedSurface {
  geometry::TriangleMesh mesh;
  /// The file's world, in metres and with z up, → this frame (scan_frame.h).
  RigidMotion from_world = RigidMotion::Identity();
  std::vector<std::string> warnings;
};

/// Drops what is not skin (repeated faces, loose vertices, specks), closes seams and small holes,
/// orients, scales, turns and checks a scan. What it changes is told in warnings.
/// \throws GeometryError when it has a wide hole, is not orientable or not manifold, or is more
/// than one piece (says where, in metres of the file's world); InvalidInput when no unit makes it a
/// person.
CheckedSurface check_surface(geometry::TriangleMesh mesh, const ScanOptions& options);

}  // namespace loosefit::body
