#pragma once
#include "loosefit/pattern/pattern.h"

namespace loosefit::kinds {

/// Width of half a sleeve square to its top seam, which may turn at the elbow, so far down from the
/// cap [m]; 0 where there is none.
double width_below_cap(const pattern::Panel& half, double down);

}  // namespace loosefit::kinds
