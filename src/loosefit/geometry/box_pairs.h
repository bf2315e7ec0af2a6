#pragma once
#include <utility>
#include <vector>

#include "loosefit/geometry/box_grid.h"

namespace loosefit::geometry {

/// Pairs (i, j) of overlapping boxes, i from `a`, j from `b`, sorted. Uniform grid, built per call;
/// best for many boxes of similar size. Closed boxes: touching counts as overlap.
std::vector<std::pair<int, int>> overlapping_boxes(const std::vector<Box3>& a,
                                                   const std::vector<Box3>& b);
/// Pairs (i, j), i < j, of overlapping boxes of one set, sorted.
std::vector<std::pair<int, int>> overlapping_boxes(const std::vector<Box3>& boxes);

}  // namespace loosefit::geometry
