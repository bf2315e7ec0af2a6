#include "loosefit/study/sites_csv.h"

#include <cmath>
#include <set>

#include "loosefit/base/text.h"

namespace loosefit {
namespace {

std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string field(double value) { return std::isfinite(value) ? shortest(value) : std::string(); }

}  // namespace

std::string sites_csv(const std::vector<Site>& sites) {
  std::set<std::string> arrays;
  for (const Site& site : sites)
    for (const auto& entry : site.values) arrays.insert(entry.first);
  std::vector<std::string> row = {"name", "region", "panel", "u_m", "v_m", "x_m", "y_m", "z_m"};
  for (const std::string& array : arrays) {
    row.push_back(array);
    row.push_back(array + "_worst");
  }
  std::string text = join(row, ",") + "\n";
  for (const Site& site : sites) {
    row = {field(site.name),         field(name(site.region)), field(site.panel),
           field(site.at.x()),       field(site.at.y()),       field(site.position.x()),
           field(site.position.y()), field(site.position.z())};
    for (const std::string& array : arrays) {
      const auto value = site.values.find(array);
      row.push_back(value == site.values.end() ? "" : field(value->second.mean));
      row.push_back(value == site.values.end() ? "" : field(value->second.worst));
    }
    text += join(row, ",") + "\n";
  }
  return text;
}

}  // namespace loosefit
