#pragma once
#include <cmath>

namespace loosefit::kinds {

/// The greatest figure of three decimal places that is not above a limit: an "at most" that can be
/// written as it is told, where the nearest figure may be refused. The double that its text reads
/// as. Of finite limits below 1e9 in size; any unit.
inline double told_most(double limit) {
  const double nearest = std::round(1000 * limit);
  return (nearest / 1000 > limit ? nearest - 1 : nearest) / 1000 + 0.0;  // no −0
}

/// The least such figure that is not below a limit: an "at least".
inline double told_least(double limit) { return 0.0 - told_most(-limit); }

}  // namespace loosefit::kinds
