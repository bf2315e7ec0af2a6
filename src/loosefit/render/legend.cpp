#include "loosefit/render/legend.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace loosefit::render {

std::string tick_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", std::abs(value) < 1e-12 ? 0.0 : value);
  return text[0] == '-' ? "\u2212" + std::string(text + 1) : text;
}

std::string legend_title(const maps::MapArrayStyle& style) {
  const bool plain = style.unit.empty() || style.unit == "–" || style.unit == "-";
  return style.title + (plain ? "" : " [" + style.unit + "]");
}

std::vector<LegendTick> legend_ticks(const maps::MapArrayStyle& style, bool values_below,
                                     bool values_above) {
  std::vector<double> at = style.breaks;
  if (at.empty())
    for (int i = 0; i < 5; ++i)
      at.push_back(style.range_low + (style.range_high - style.range_low) * i / 4);
  std::vector<LegendTick> ticks;
  for (std::size_t i = 0; i < at.size(); ++i)
    ticks.push_back(
        {static_cast<double>(i) / static_cast<double>(at.size() - 1), tick_text(at[i])});
  if (values_below) ticks.front().text = "\u2264 " + ticks.front().text;
  if (values_above) ticks.back().text = "\u2265 " + ticks.back().text;
  return ticks;
}

std::pair<double, double> value_range(const std::vector<double>& values) {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (double value : values)
    if (!std::isnan(value)) {
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  return {lowest, highest};
}

void draw_legend(Image& image, const maps::PerformanceMap& map, int height) {
  // Title with unit above the bar.
  const int top = image.height - height, text_size = height / 5;
  const int left = image.width / 8, right = image.width - left;
  draw_text(image, legend_title(map), image.width / 2, top + height / 16, text_size + 2, 0,
            {20, 20, 20}, true);

  // The bar, all entries of the colour table from left to right.
  const int bar_top = top + height * 6 / 16, bar_bottom = top + height * 10 / 16;
  fill(image, left - 1, bar_top - 1, right + 1, bar_bottom + 1, {60, 60, 60});
  for (int x = left; x < right; ++x) {
    const int entry = std::min(255, (x - left) * 256 / (right - left));
    fill(image, x, bar_top, x + 1, bar_bottom, colours_of(map)[entry]);
  }

  const auto [lowest, highest] = value_range(map.values);
  for (const LegendTick& tick : legend_ticks(map, lowest<map.range_low, highest> map.range_high)) {
    const int x = left + static_cast<int>(std::lround((right - 1 - left) * tick.share));
    fill(image, x, bar_bottom, x + 1, bar_bottom + height / 20, {60, 60, 60});
    draw_text(image, tick.text, x, bar_bottom + height / 14, text_size, 0);
  }
}

}  // namespace loosefit::render
