#pragma once
#include <utility>
#include <vector>

#include "loosefit/base/types.h"
#include "loosefit/geometry/closest_point_tree.h"

namespace loosefit::drape {

/// Cloth after smooth_cuts.
struct SmoothedCuts {
  std::vector<Vec3> x;                       ///< [m]
  int first_cuts = 0, cuts = 0;              ///< pairs of triangles that cut each other before, now
  std::pair<int, int> first_cut = {-1, -1};  ///< one of those that are left
};

/// Moves the vertices near triangles that cut each other to the middle of their neighbours, in ever
/// wider rings, until none does or after so many rounds, and out of the skin by `clear` [m]. Smooth
/// cloth cuts nothing.
SmoothedCuts smooth_cuts(std::vector<Vec3> x, const std::vector<Triangle>& triangles,
                         const geometry::ClosestPointTree& skin, double clear, int rounds);

}  // namespace loosefit::drape
