#pragma once
#include <vector>

#include "loosefit/kinds/kind.h"

namespace loosefit::kinds {

/// Fixed shirts: the standard body each is cut for and its ease. One garment for all bodies.
const std::vector<KindSize>& shirt_sizes();

}  // namespace loosefit::kinds
