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

void draw_legend(Image& image, const maps::PerformanceMap& map, int height) {
  // Title with unit above the bar.
  const int top = image.height - height, text_size = height / 5;
  const int left = image.width / 8, right = image.width - left;
  const bool plain = map.unit.empty() || map.unit == "–" || map.unit == "-";
  draw_text(image, map.title + (plain ? "" : " [" + map.unit + "]"), image.width / 2,
            top + height / 16, text_size + 2, 0, {20, 20, 20}, true);

  // The bar, all entries of the colour table from left to right.
  const int bar_top = top + height * 6 / 16, bar_bottom = top + height * 10 / 16;
  fill(image, left - 1, bar_top - 1, right + 1, bar_bottom + 1, {60, 60, 60});
  for (int x = left; x < right; ++x) {
    const int entry = std::min(255, (x - left) * 256 / (right - left));
    fill(image, x, bar_top, x + 1, bar_bottom, colours_of(map)[entry]);
  }

  // Whether values lie beyond the ends of the bar.
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (double value : map.values)
    if (!std::isnan(value)) {
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  // Ticks at the breaks of the map, or at quarters of its range.
  std::vector<double> ticks = map.breaks;
  if (ticks.empty())
    for (int i = 0; i < 5; ++i)
      ticks.push_back(map.range_low + (map.range_high - map.range_low) * i / 4);
  const int last = static_cast<int>(ticks.size()) - 1;
  for (int i = 0; i <= last; ++i) {
    const double value = ticks[i];
    const int x = left + (right - 1 - left) * i / last;
    fill(image, x, bar_bottom, x + 1, bar_bottom + height / 20, {60, 60, 60});
    std::string text = tick_text(value);
    if (i == 0 && lowest < map.range_low) text = "\u2264 " + text;
    if (i == last && highest > map.range_high) text = "\u2265 " + text;
    draw_text(image, text, x, bar_bottom + height / 14, text_size, 0);
  }
}

}  // namespace loosefit::render
