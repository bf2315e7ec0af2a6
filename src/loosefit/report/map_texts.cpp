#include "loosefit/report/map_texts.h"

#include <algorithm>

#include "loosefit/report/html.h"

namespace loosefit {
namespace {

bool is_strain(const PerformanceMap& map) { return map.array.rfind("strain", 0) == 0; }

}  // namespace

std::string with_unit(const PerformanceMap& map) {
  const std::string unit = is_strain(map) ? "%" : map.unit;
  return unit.empty() || unit == "–" ? map.title : map.title + " [" + unit + "]";
}

bool is_companion(const PerformanceMap& map) {
  for (const char* array : {"strain_max", "strain_min", "slack", "distance_particle_mm",
                            "pressure_membrane_kPa", "pressure_difference_kPa", "contact"})
    if (map.array == array) return true;
  return false;
}

std::string value_text(const PerformanceMap& map, double value) {
  if (map.unit == "kPa") return fixed(value, 3);
  return is_strain(map) ? fixed(100 * value, 2) : fixed(value, 1);
}

std::string spaced(std::string text) {
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

}  // namespace loosefit
