#pragma once
#include <array>
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::render {

/// What a cut leaves of a surface.
struct ClippedSurface {
  geometry::TriangleMesh mesh;
  std::vector<int> origin;  ///< per vertex: the one that it was, on the rim one beside it
  std::vector<std::array<int, 2>> rim;  ///< the new edges, in no order
};

/// The part of a surface where `keep` (per vertex) is ≥ 0; triangles are split where it crosses
/// zero.
ClippedSurface clipped(const geometry::TriangleMesh& mesh, const std::vector<double>& keep);

/// Closes a rim by triangles to the middle of it, their fronts towards `outwards`: a lid if the rim
/// is one plane loop all of which is seen from there. The lid has vertices of its own, the last of
/// the mesh, so that what it closes keeps its normals.
void close_with_fan(geometry::TriangleMesh& mesh, const std::vector<std::array<int, 2>>& rim,
                    const Vec3& outwards);

}  // namespace loosefit::render
