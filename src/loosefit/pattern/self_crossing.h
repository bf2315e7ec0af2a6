#pragma once
#include <utility>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::pattern {

/// Index pair of two polygon sides that cross or touch away from a shared corner; {-1, -1} if
/// simple.
std::pair<int, int> first_self_crossing(const std::vector<Vec2>& polygon);

}  // namespace loosefit::pattern
