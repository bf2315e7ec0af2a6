#pragma once
#include <string>
#include <utility>
#include <vector>

#include "loosefit/maps/performance_map.h"
#include "loosefit/render/image.h"

namespace loosefit::render {

/// "Body-garment distance [mm]"
std::string legend_title(const maps::MapArrayStyle& style);

/// Where a colour bar has a tick, and what it says.
struct LegendTick {
  double share = 0;  ///< place on the bar, 0 to 1
  std::string text;
};
/// At the breaks of the map, or at quarters of its range. With values below the bar's lower end
/// the first carries ≤, with values above its upper end the last carries ≥.
std::vector<LegendTick> legend_ticks(const maps::MapArrayStyle& style, bool values_below,
                                     bool values_above);

/// Smallest and largest of values; NaN do not count. Empty: (∞, −∞).
std::pair<double, double> value_range(const std::vector<double>& values);

/// Draws the map's colours as a horizontal bar with title, unit and ticks, five or at its breaks,
/// into the band of `height` pixels at the foot of `image`. Ends that stand for "and beyond" carry
/// ≤ and ≥.
void draw_legend(Image& image, const maps::PerformanceMap& map, int height);

/// Tick text without needless digits: 0.05 → "0.05", 20 → "20", −0.1 → "−0.1".
std::string tick_text(double value);

}  // namespace loosefit::render
