#pragma once
#include <vector>

#include "loosefit/maps/performance_map.h"

namespace loosefit::maps {

/// What a colour range has to hold: of the values, 2 % by weight lie below `low` and 2 % above
/// `high`. Both NaN where nothing is defined.
struct ValueSpread {
  double low = 0, high = 0;
};
ValueSpread value_spread(const std::vector<double>& values, const std::vector<double>& weights);

/// Sets the colour range of an array to round ends that hold the spreads of all drapes that are
/// compared: from zero, or symmetric for a signed quantity, to 1, 2, 4, 6 or 8 times a power of
/// ten. Values beyond it stay at its ends, where the legends mark them. A range with breaks, which
/// are limits of use, stays as it is, and so does one that is a share from 0 to 1. Never narrower
/// than a hundredth of the fixed range, so that noise is not coloured.
void fit_range(MapArrayStyle& style, const std::vector<ValueSpread>& spreads);

}  // namespace loosefit::maps
