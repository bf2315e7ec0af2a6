#pragma once
#include <utility>
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::flesh {

/// A piece of a surface with vertex numbers of its own.
struct SkinPatch {
  std::vector<int> vertex;          ///< of the whole surface, rising
  std::vector<Triangle> triangles;  ///< in numbers of the patch
  std::vector<char> on_rim;         ///< vertices beyond which the surface goes on

  /// What belongs to the patch of a list for the whole surface.
  std::vector<Vec3> of(const std::vector<Vec3>& surface) const;
};

/// The skin within `margin` [m] of triangles that overlap, in places up to 2√3 times as far.
SkinPatch patch_round(const geometry::TriangleMesh& skin,
                      const std::vector<std::pair<int, int>>& overlaps, double margin);

}  // namespace loosefit::flesh
