#include "loosefit/pipeline/sites_csv.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "loosefit/io/address_columns.h"
#include "loosefit/io/csv.h"
#include "loosefit/pipeline/site_values.h"

namespace loosefit::pipeline {

std::string sites_csv(const std::vector<placement::Site>& sites, double edge_length,
                      const std::vector<placement::UncoveredSite>& uncovered,
                      const std::vector<CaseLine>& lines) {
  // Sites may lack a value: the columns are those of all sites together.
  std::vector<std::map<std::string, double>> values;
  std::set<std::string> names;
  for (const placement::Site& site : sites) {
    values.push_back(site_values(site));
    for (const auto& [name, known] : site_uncertainty(site, edge_length))
      values.back()["uncertainty." + name] = known.whole();
    for (const auto& entry : values.back()) names.insert(entry.first);
  }
  // Header: place, anatomical address, footprint, the values, cover.
  std::vector<std::string> row = {"name", "region", "panel", "u_m",      "v_m",
                                  "x_m",  "y_m",    "z_m",   "angle_deg"};
  row.insert(row.end(), io::address_columns().begin(), io::address_columns().end());
  row.push_back("footprint");
  row.insert(row.end(), names.begin(), names.end());
  row.insert(row.end(), {"covered", "why_not_covered"});
  const std::size_t cover = row.size() - 2;
  // Lines have columns of their own, which are there with lines only.
  const std::vector<std::string> of_line = {"kind", "length_cut_m", "length_worn_m", "elongation",
                                            "elongation_largest"};
  if (!lines.empty()) row.insert(row.end(), of_line.begin(), of_line.end());
  const std::size_t columns = row.size();
  std::string text = io::csv_line(row);
  // Sites on the garment; a value that is missing is an empty field.
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const placement::Site& site = sites[i];
    row = {io::csv_field(site.name), io::csv_field(body::name(site.region)),
           io::csv_field(site.panel)};
    for (double value : {site.at.x(), site.at.y(), site.position.x(), site.position.y(),
                         site.position.z(), std::round(degrees(site.angle) * 1e8) / 1e8})
      row.push_back(io::csv_field(value));
    for (const std::string& field : io::address_fields(site.anatomy)) row.push_back(field);
    row.push_back(io::csv_field(in_words(site.shape)));
    for (const std::string& name : names) {
      const auto value = values[i].find(name);
      row.push_back(value == values[i].end() ? "" : io::csv_field(value->second));
    }
    row.push_back(site.not_covering.empty() ? "yes" : "no");
    row.push_back(io::csv_field(site.not_covering));
    if (!lines.empty()) row.push_back("place");
    row.resize(columns);
    text += io::csv_line(row);
  }
  // Sites off the garment that were asked for; presets that miss it are no news.
  for (const placement::UncoveredSite& site : uncovered) {
    if (site.preset) continue;
    row.assign(columns, "");
    row.front() = io::csv_field(site.name);
    row[cover] = "no";
    row[cover + 1] = io::csv_field(site.why);
    if (!lines.empty()) row[cover + 2] = "place";
    text += io::csv_line(row);
  }
  for (const CaseLine& line : lines) {
    row.assign(columns, "");
    row.front() = io::csv_field(line.name);
    row[cover] = "yes";
    row[cover + 2] = "line";
    row[cover + 3] = io::csv_field(line.course.length);
    if (!line.states.empty()) {
      double most = line.states.front().elongation;
      for (const lines::LineState& state : line.states) most = std::max(most, state.elongation);
      row[cover + 4] = io::csv_field(line.states.front().length);
      row[cover + 5] = io::csv_field(line.states.front().elongation);
      row[cover + 6] = io::csv_field(most);
    }
    text += io::csv_line(row);
  }
  return text;
}

}  // namespace loosefit::pipeline
