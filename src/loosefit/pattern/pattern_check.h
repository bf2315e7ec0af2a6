#pragma once
#include "loosefit/pattern/pattern.h"

namespace loosefit::pattern {

/// Structure every later step relies on: indices in range, closed simple counter-clockwise loops,
/// finite sizes, each edge in at most one seam. \throws GeometryError naming panel and edge.
void check_pattern(const Pattern& pattern);

}  // namespace loosefit::pattern
