#pragma once
#include <array>
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit {

/// What a cut leaves of a surface.
struct ClippedSurface {
  TriangleMesh mesh;
  std::vector<int> origin;  ///< per vertex: the one that it was, on the rim one beside it
  std::vector<std::array<Vec3, 2>> rim;  ///< the new edges [m], in no order
};

/// The part of a surface where `keep` (per vertex) is ≥ 0; triangles are split where it crosses
/// zero.
ClippedSurface clipped(const TriangleMesh& mesh, const std::vector<double>& keep);

/// Adds a flat lid over a rim, its front towards `outwards`.
void close_with_fan(TriangleMesh& mesh, const std::vector<std::array<Vec3, 2>>& rim,
                    const Vec3& outwards);

}  // namespace loosefit
