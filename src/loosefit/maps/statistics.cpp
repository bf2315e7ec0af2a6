#include "loosefit/maps/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/quantile.h"

namespace loosefit::maps {

MapStatistics statistics(const std::vector<double>& values, const std::vector<double>& weights) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  MapStatistics s;
  std::vector<int> order;
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) {
      ++s.undefined;
    } else if (weights[i] > 0) {
      order.push_back(static_cast<int>(i));
      s.area += weights[i];
      sum += weights[i] * values[i];
    }
  }
  if (order.empty()) {
    s.min = s.p5 = s.median = s.p95 = s.max = s.area_mean = kNan;
    return s;
  }
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return values[i] < values[j]; });
  const auto quantile = [&](double share) {
    return weighted_quantile(values, weights, order, s.area, share);
  };
  s.min = values[order.front()];
  s.p5 = quantile(0.05);
  s.median = quantile(0.5);
  s.p95 = quantile(0.95);
  s.max = values[order.back()];
  s.area_mean = sum / s.area;
  return s;
}

std::map<body::Region, MapStatistics> regional_statistics(
    const std::vector<double>& values, const std::vector<double>& weights,
    const std::vector<body::Region>& regions) {
  std::map<body::Region, MapStatistics> result;
  for (body::Region region : body::all_regions()) {
    std::vector<double> own, own_weights;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (regions[i] == region) {
        own.push_back(values[i]);
        own_weights.push_back(weights[i]);
      }
    const MapStatistics s = statistics(own, own_weights);
    if (s.area > 0) result[region] = s;
  }
  return result;
}

}  // namespace loosefit::maps
