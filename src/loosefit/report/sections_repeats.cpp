#include "loosefit/pipeline/repeat_drapes.h"
#include "loosefit/report/html.h"
#include "loosefit/report/map_texts.h"
#include "loosefit/report/sections.h"

namespace loosefit::report {
namespace {

/// "10.3 ± 0.4", or a dash where no drape has a value.
std::string spread_text(const pipeline::CaseResult& result, const maps::PerformanceMap& map,
                        const std::string& key) {
  const auto found = result.repeats.spread.find(key);
  if (found == result.repeats.spread.end()) return "–";
  return value_text(map, found->second.mean) + " ± " + value_text(map, found->second.deviation);
}

}  // namespace

std::string repeat_section(const pipeline::CaseResult& result) {
  if (result.repeats.spread.empty()) return {};
  std::vector<std::string> head = {"where"}, whole = {"whole garment, area mean"};
  std::vector<const maps::PerformanceMap*> shown;
  for (const pipeline::CaseMap& entry : result.studied().maps.maps) {
    if (entry.map.companion) continue;
    shown.push_back(&entry.map);
    head.push_back(with_unit(entry.map));
    whole.push_back(spread_text(result, entry.map, pipeline::map_spread_key(entry.map.array)));
  }
  Table table(head);
  table.add(whole);
  for (const placement::Site& site : result.sites) {
    std::vector<std::string> row = {spaced(site.name)};
    for (const maps::PerformanceMap* map : shown)
      row.push_back(spread_text(result, *map, pipeline::site_spread_key(site.name, map->array)));
    table.add(row);
  }
  return element("h2", "Spread over drapes from other starts") + table.html() +
         element("p", "Mean ± sample standard deviation of " +
                          std::to_string(result.repeats.spread.begin()->second.count) +
                          " drapes of the same garment on the same body. Folds are not unique: a "
                          "difference smaller than this may be chance.");
}

}  // namespace loosefit::report
