#include "loosefit/solver/line_search.h"

#include <algorithm>
#include <cmath>

namespace loosefit::solver {
namespace {

/// Doubles t while that pays. energy: φ(t), t the trial point that was kept last.
double extend(SearchLine& line, const SearchStart& start, const LineSearchTuning& tuning, double t,
              double energy) {
  while (2 * t <= start.limit) {
    if (line.slope() > start.slope / tuning.extension_slope_divisor) break;
    const double farther = line.energy(2 * t);
    if (!(farther < energy)) break;
    energy = farther;
    t *= 2;
    line.keep();
  }
  return t;
}

}  // namespace

SearchResult line_search(SearchLine& line, const SearchStart& start,
                         const LineSearchTuning& tuning) {
  SearchResult result;
  if (!(start.limit > 0)) return result;
  double t = std::min(start.limit, start.first);
  for (int k = 0; k < tuning.max_backtracks; ++k, t *= 0.5) {
    const double energy = line.energy(t);
    // Near the end the decrease is below the round-off of the energy.
    const bool below_round_off =
        tuning.accept_below_round_off &&
        std::abs(start.slope * t) <
            tuning.round_off * (std::abs(start.energy) + tuning.round_off_floor);
    bool accept = energy <= start.energy + tuning.armijo * t * start.slope;
    if (!accept && below_round_off && std::isfinite(energy))
      accept = line.squared_force() < start.force * start.force;
    if (!accept) continue;
    line.keep();
    // A step that had to be cut back has met its limit; only a first trial may be doubled.
    if (k == 0 && !below_round_off) t = extend(line, start, tuning, t, energy);
    result = {true, t, below_round_off};
    break;
  }
  return result;
}

}  // namespace loosefit::solver
