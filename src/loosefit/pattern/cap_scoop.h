#pragma once
#include "loosefit/pattern/sections.h"

namespace loosefit::pattern {

constexpr double kScoopTells = 0.02;  ///< |cap_scoop| from which a cap tells its front

/// How much less the half of a cap behind its top (at the end of the outline's way) bulges than the
/// half before: the front of a cap is cut out more. Positive: the way begins at the front, as that
/// of a right sleeve does. Share of the box round a half.
double cap_scoop(const Panel& panel, const Section& cap);

}  // namespace loosefit::pattern
