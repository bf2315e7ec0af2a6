#include "loosefit/maps/fit_range.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/quantile.h"

namespace loosefit::maps {
namespace {

constexpr double kTail = 0.02;  ///< of the weight that may lie beyond either end

/// The next of 1, 2, 4, 6, 8 times a power of ten: quarters of it are round numbers, too.
double round_up(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 4.0, 6.0, 8.0})
    if (value <= step * power * (1 + 1e-9)) return step * power;
  return 10 * power;
}

}  // namespace

ValueSpread value_spread(const std::vector<double>& values, const std::vector<double>& weights) {
  std::vector<int> known;
  double total = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i]) && weights[i] > 0) {
      known.push_back(static_cast<int>(i));
      total += weights[i];
    }
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  if (known.empty()) return {kNan, kNan};
  std::sort(known.begin(), known.end(), [&](int a, int b) { return values[a] < values[b]; });
  return {weighted_quantile(values, weights, known, total, kTail),
          weighted_quantile(values, weights, known, total, 1 - kTail)};
}

void fit_range(MapArrayStyle& style, const std::vector<ValueSpread>& spreads) {
  const bool share = style.range_low == 0 && style.range_high == 1;
  if (!style.breaks.empty() || share) return;
  double most = 0.01 * std::max(std::abs(style.range_low), std::abs(style.range_high));
  bool known = false;
  for (const ValueSpread& spread : spreads) {
    if (std::isnan(spread.low)) continue;
    known = true;
    most = std::max(most, style.diverging ? std::max(-spread.low, spread.high) : spread.high);
  }
  if (!known) return;
  style.range_high = round_up(most);
  style.range_low = style.diverging ? -style.range_high : 0;
}

}  // namespace loosefit::maps
