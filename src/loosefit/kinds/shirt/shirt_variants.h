#pragma once
#include <vector>

#include "loosefit/pattern/pattern.h"

namespace loosefit::kinds {

/// One draft for every way in which pieces of a shirt are sewn: without and with its darts,
/// those of the back, neckband and cuffs. By these a pattern file is recognised.
const std::vector<pattern::Pattern>& shirt_variants();

}  // namespace loosefit::kinds
