#include "loosefit/report/map_texts.h"

#include <algorithm>

#include "loosefit/report/html.h"

namespace loosefit::report {
std::string with_unit(const maps::PerformanceMap& map) {
  const std::string unit = map.percent ? "%" : map.unit;
  return unit.empty() || unit == "–" ? map.title : map.title + " [" + unit + "]";
}

std::string value_text(const maps::PerformanceMap& map, double value) {
  return fixed(map.percent ? 100 * value : value, map.decimals);
}

std::string spaced(std::string text) {
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

}  // namespace loosefit::report
