#include "loosefit/base/quantile.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/check.h"

namespace loosefit {

std::size_t quantile_index(std::size_t n, double share) {
  // The slack keeps 0.05 · 20 = 1.0000000000000002 from counting as two.
  const double place = std::ceil(share * static_cast<double>(n) - 1e-9);
  return static_cast<std::size_t>(std::clamp(place, 1.0, static_cast<double>(n))) - 1;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(quantile_index(values.size(), share));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double weighted_quantile(const std::vector<double>& values, const std::vector<double>& weights,
                         const std::vector<int>& ascending, double total, double share) {
  LOOSEFIT_ASSERT(!ascending.empty());
  double below = 0;
  for (int i : ascending) {
    below += weights[i];
    if (below >= share * total * (1 - 1e-12)) return values[i];  // the slack is for rounding
  }
  return values[ascending.back()];
}

}  // namespace loosefit
