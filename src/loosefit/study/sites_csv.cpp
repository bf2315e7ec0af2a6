#include "loosefit/study/sites_csv.h"

#include <cmath>
#include <set>

#include "loosefit/io/address_columns.h"
#include "loosefit/io/csv.h"

namespace loosefit {

std::string sites_csv(const std::vector<Site>& sites, const std::vector<UncoveredSite>& uncovered) {
  std::set<std::string> arrays;
  for (const Site& site : sites)
    for (const auto& entry : site.values) arrays.insert(entry.first);
  std::vector<std::string> row = {"name", "region", "panel", "u_m",      "v_m",
                                  "x_m",  "y_m",    "z_m",   "angle_deg"};
  row.insert(row.end(), address_columns().begin(), address_columns().end());
  for (const std::string& array : arrays) {
    row.push_back(array);
    row.push_back(array + "_worst");
  }
  row.insert(row.end(), {"covered", "why_not_covered"});
  const std::size_t columns = row.size();
  std::string text = csv_line(row);
  for (const Site& site : sites) {
    row = {csv_field(site.name), csv_field(name(site.region)), csv_field(site.panel)};
    for (double value : {site.at.x(), site.at.y(), site.position.x(), site.position.y(),
                         site.position.z(), std::round(degrees(site.angle) * 1e8) / 1e8})
      row.push_back(csv_field(value));
    for (const std::string& field : address_fields(site.anatomy)) row.push_back(field);
    for (const std::string& array : arrays) {
      const auto value = site.values.find(array);
      row.push_back(value == site.values.end() ? "" : csv_field(value->second.mean));
      row.push_back(value == site.values.end() ? "" : csv_field(value->second.worst));
    }
    row.push_back(site.not_covering.empty() ? "yes" : "no");
    row.push_back(csv_field(site.not_covering));
    text += csv_line(row);
  }
  for (const UncoveredSite& site : uncovered) {
    if (site.preset) continue;
    row.assign(columns, "");
    row.front() = csv_field(site.name);
    row[columns - 2] = "no";
    row.back() = csv_field(site.why);
    text += csv_line(row);
  }
  return text;
}

}  // namespace loosefit
