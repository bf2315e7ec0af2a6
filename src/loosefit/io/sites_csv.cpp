#include "loosefit/io/sites_csv.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "loosefit/base/error.h"

namespace loosefit {
namespace {
std::string cell(double value) { return std::isnan(value) ? "" : fmt::format("{:.6g}", value); }

/// RFC 4180: quotes round texts with separators, quotes doubled.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}
}  // namespace

void write_sites_csv(const std::filesystem::path& path, const std::vector<Site>& sites) {
  std::string text = "name,panel,u_m,v_m,x_m,y_m,z_m,region";
  if (!sites.empty())
    for (const auto& [array, value] : sites.front().values)
      text += "," + array + "," + array + "_p95";
  text += "\n";
  for (const Site& s : sites) {
    text += cell(s.name) + "," + cell(s.panel);
    for (double v : {s.at.x(), s.at.y(), s.position.x(), s.position.y(), s.position.z()})
      text += "," + cell(v);
    text += "," + name(s.region);
    for (const auto& [array, value] : s.values)
      text += "," + cell(value.mean) + "," + cell(value.worst);
    text += "\n";
  }
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file)
    throw IoError("cannot write " + path.string(), "is the folder there, writable and not full?");
}

}  // namespace loosefit
