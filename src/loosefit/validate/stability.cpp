#include "loosefit/validate/stability.h"

#include <limits>

#include "loosefit/solver/stability.h"

namespace loosefit::validate {

bool is_stable(Bench& bench) { return solver::is_stable(bench.system(), bench.x, {.neutral = 0}); }

double critical_factor(const std::function<bool(double)>& stable, double low, double high,
                       double tolerance) {
  if (!stable(low) || stable(high)) return std::numeric_limits<double>::quiet_NaN();
  while (high - low > tolerance * low) {
    const double middle = 0.5 * (low + high);
    (stable(middle) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace loosefit::validate
