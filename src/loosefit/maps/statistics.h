#pragma once
#include <map>
#include <vector>

#include "loosefit/body/regions.h"
#include "loosefit/maps/performance_map.h"

namespace loosefit::maps {

/// Area-weighted summary of one map; every field NaN when nothing is defined.
struct MapStatistics {
  double min = 0, p5 = 0, median = 0, p95 = 0, max = 0;
  double area_mean = 0;
  double area = 0;    ///< flat area with a value [m²]
  int undefined = 0;  ///< vertices with NaN
};

/// Quantile q: the smallest value such that at least the share q of the weight lies at or below it.
/// NaN values and zero weights do not count.
MapStatistics statistics(const std::vector<double>& values, const std::vector<double>& weights);

/// The same within each region that has a value; `regions` per vertex.
std::map<body::Region, MapStatistics> regional_statistics(const std::vector<double>& values,
                                                          const std::vector<double>& weights,
                                                          const std::vector<body::Region>& regions);

}  // namespace loosefit::maps
