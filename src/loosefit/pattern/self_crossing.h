#pragma once
#include <utility>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::pattern {

/// Index pair of two polygon sides that cross or touch away from a shared corner; {-1, -1} if
/// simple.
std::pair<int, int> first_self_crossing(const std::vector<Vec2>& polygon);

/// Whether a side of one polygon crosses or touches a side of the other.
bool polygons_meet(const std::vector<Vec2>& a, const std::vector<Vec2>& b);

}  // namespace loosefit::pattern
