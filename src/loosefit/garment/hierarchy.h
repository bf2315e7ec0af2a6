#pragma once
#include <vector>

#include "loosefit/garment/garment.h"

namespace loosefit {

/// The same garment on nested meshes, coarse to fine. Each finer level splits every triangle of the
/// coarser one into four at its edge midpoints, so the coarse surface is exactly representable on
/// the fine mesh and a drape free of intersections stays so when it is carried over.
struct GarmentHierarchy {
  std::vector<Garment> levels;  ///< at least one; back() is the wanted resolution
  /// For level l ≥ 1 and each of its vertices: the two coarse vertices of level l−1 whose midpoint
  /// it is; equal indices for a vertex kept from the coarser level.
  std::vector<std::vector<std::array<int, 2>>> parents;
  Pattern pattern;

  const Garment& finest() const { return levels.back(); }
};

}  // namespace loosefit
