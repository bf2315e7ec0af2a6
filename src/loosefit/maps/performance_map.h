#pragma once
#include <string>
#include <vector>

namespace loosefit::maps {

/// How an array of a map is called, written and drawn.
struct MapArrayStyle {
  std::string array;       ///< name in drape.vtp and summary.json, unit in the name: "distance_mm"
  std::string title;       ///< "Body-garment distance"
  std::string unit = "–";  ///< "mm", "deg", "–"
  double range_low = 0, range_high = 1;  ///< fixed colour range of this quantity
  std::string map;                       ///< stem of its pictures: "strain", "distance"
  bool pictured = true;                  ///< drawn by default
  bool diverging = false;                ///< signed quantity: colours split at zero
  /// Values that lie at equal steps of the colour bar, ascending from range_low to range_high:
  /// between them the scale is linear. Empty: one linear scale.
  std::vector<double> breaks = {};
  int decimals = 1;        ///< of a value in the report
  bool percent = false;    ///< the report shows a hundred times the value
  bool companion = false;  ///< written and summed up, but not shown per region and site
};

/// One scalar field on the garment, one value per garment vertex; NaN where it is not defined.
struct PerformanceMap : MapArrayStyle {
  std::vector<double> values;
};

}  // namespace loosefit::maps
