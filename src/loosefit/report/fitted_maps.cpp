#include "loosefit/report/fitted_maps.h"

#include <algorithm>
#include <map>

#include "loosefit/maps/fit_range.h"

namespace loosefit::report {

std::vector<maps::MapArrayStyle> fitted_styles(const pipeline::CaseResult& result) {
  std::vector<maps::MapArrayStyle> styles;
  std::map<std::string, std::vector<maps::ValueSpread>> spreads;
  const auto add = [&](const std::vector<pipeline::CaseMap>& maps, const maps::WornGarment& worn) {
    for (const pipeline::CaseMap& entry : maps) {
      std::vector<maps::ValueSpread>& own = spreads[entry.map.array];
      if (own.empty()) styles.push_back(entry.map);
      const std::vector<double>& values = entry.map.values;
      own.push_back(maps::value_spread(values, worn.areas.size() == values.size()
                                                   ? worn.areas
                                                   : std::vector<double>(values.size(), 1.0)));
    }
  };
  add(result.studied().maps.maps, result.studied().maps.worn);
  for (const pipeline::CaseState& state : result.wear.states) add(state.maps.maps, state.maps.worn);
  for (maps::MapArrayStyle& style : styles) maps::fit_range(style, spreads[style.array]);
  return styles;
}

std::vector<maps::PerformanceMap> fitted_maps(const pipeline::CaseResult& result) {
  const std::vector<maps::MapArrayStyle> styles = fitted_styles(result);
  std::vector<maps::PerformanceMap> maps;
  for (const pipeline::CaseMap& entry : result.studied().maps.maps) {
    maps.push_back(entry.map);
    const auto style = std::find_if(styles.begin(), styles.end(),
                                    [&](const auto& s) { return s.array == entry.map.array; });
    maps.back().range_low = style->range_low;
    maps.back().range_high = style->range_high;
  }
  return maps;
}

}  // namespace loosefit::report
