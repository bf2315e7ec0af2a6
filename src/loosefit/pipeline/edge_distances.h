#pragma once
#include <vector>

#include "loosefit/pattern/pattern.h"

namespace loosefit::pipeline {

/// A distance that a tape can measure: from a place to the nearest point of an edge of its piece.
struct EdgeDistance {
  int edge = 0;
  Vec2 foot = Vec2::Zero();  ///< [m]
  double length = 0;         ///< [m]
};

/// The distance to the nearest edge, and to the nearest of those whose foot lies in another
/// direction by 45 to 135 degrees, so that the two fix the place; the second may be missing.
std::vector<EdgeDistance> edge_distances(const pattern::Panel& panel, const Vec2& at);

}  // namespace loosefit::pipeline
