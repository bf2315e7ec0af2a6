#pragma once
#include <vector>

#include "loosefit/garment/garment.h"

namespace loosefit::garment {

/// A sewn garment with its seams open: the same triangles in the same order, but every panel has
/// vertices of its own, and so have both sides of a dart.
struct OpenSeams {
  /// Without edge chains and attachments; vertex_mass from the mean mass per area [kg].
  Garment garment;
  std::vector<int> sewn;  ///< vertex → vertex of the sewn garment
  /// Vertices that are one in the sewn garment, where there are several.
  std::vector<std::vector<int>> partners;
};

/// Vertices are told apart by panel and pattern position.
OpenSeams open_seams(const Garment& sewn);

}  // namespace loosefit::garment
