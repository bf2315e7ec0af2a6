#pragma once
#include <string>
#include <vector>

namespace loosefit {

/// One scalar field on the garment, one value per garment vertex; NaN where it is not defined.
struct PerformanceMap {
  std::string array;  ///< name in drape.vtp and summary.json, unit in the name: "distance_mm"
  std::string title;  ///< "Body-garment distance"
  std::string unit;   ///< "mm", "deg", "–"
  double range_low = 0, range_high = 1;  ///< fixed colour range of this quantity
  std::vector<double> values;
  std::string map;         ///< user's word for it and stem of its pictures: "strain", "distance"
  bool pictured = true;    ///< drawn by default; companions of a map are only written
  bool diverging = false;  ///< signed quantity: colours split at zero
  /// Values that lie at equal steps of the colour bar, ascending from range_low to range_high:
  /// between them the scale is linear. Empty: one linear scale.
  std::vector<double> breaks = {};
};

}  // namespace loosefit
