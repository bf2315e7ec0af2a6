#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "loosefit/base/error.h"
#include "loosefit/pipeline/site_values.h"
#include "loosefit/report/html.h"
#include "loosefit/report/map_texts.h"
#include "loosefit/report/sections.h"

namespace loosefit::report {
namespace {

std::string embedded(const render::Picture& picture) {
  if (!picture.preview.empty()) return "data:image/jpeg;base64," + base64(picture.preview);
  const std::filesystem::path& file = picture.file;
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (bytes.empty()) throw IoError("cannot read the picture " + file.string());
  return "data:image/png;base64," + base64(bytes);
}

std::string title_of(const pipeline::CaseResult& result, const std::string& map) {
  for (const pipeline::CaseMap& entry : result.studied().maps.maps)
    if (entry.map.map == map) return entry.map.title;
  if (map == "layers") return "What is worn under it";
  return map == "drape" ? "The garment as it hangs" : map;
}

bool shows(const std::vector<const pipeline::CaseMap*>& shown, const std::string& array) {
  return std::any_of(shown.begin(), shown.end(),
                     [&](const pipeline::CaseMap* entry) { return entry->map.array == array; });
}

}  // namespace

std::string picture_section(const pipeline::CaseResult& result,
                            const std::vector<render::Picture>& pictures) {
  if (pictures.empty()) return {};
  std::vector<render::View> views;
  for (const render::Picture& picture : pictures)
    if (std::find(views.begin(), views.end(), picture.view) == views.end())
      views.push_back(picture.view);
  std::string html;
  for (render::View view : views) {
    std::string row;
    for (const render::Picture& picture : pictures) {
      if (picture.view != view) continue;
      const std::string title = title_of(result, picture.map) + ", " + render::name(view);
      row += "<figure><img alt=\"" + escaped(title) + "\" src=\"" + embedded(picture) +
             "\"><figcaption>" + escaped(title) + "</figcaption></figure>\n";
    }
    html += element("div", row, "pictures") + "<p></p>\n";
  }
  html +=
      element("p",
              "Colour ranges have round ends that hold 96 % of the cloth, the same for all states "
              "of this page; what lies beyond has the colour of the end, and its tick says so. "
              "Pressure and gap have their bounds of use at equal steps. Grey cloth means that a "
              "value is not defined. Seams and edges are drawn dark.");
  // Closed where the viewer above shows the same (viewer_head).
  return "<details class=\"stills\" open><summary><h2>Pictures</h2></summary>\n" + html +
         "</details>\n<script>if(document.documentElement.classList.contains('webgl'))"
         "document.querySelector('details.stills').removeAttribute('open')</script>\n";
}

std::string map_section(const pipeline::CaseResult& result) {
  // A sealed drape has no maps to sum up.
  if (result.studied().maps.maps.empty()) return {};
  // Each map over the whole garment.
  Table overall({"Map", "least", "5 %", "median", "95 %", "greatest", "area mean"});
  overall.make_sortable("maps");
  for (std::size_t column : {2, 3, 4, 6}) overall.define(column, "percentiles");
  for (const pipeline::CaseMap& entry : result.studied().maps.maps) {
    const maps::MapStatistics& s = entry.overall;
    std::vector<std::string> row = {with_unit(entry.map)};
    for (double value : {s.min, s.p5, s.median, s.p95, s.max, s.area_mean})
      row.push_back(value_text(entry.map, value));
    overall.add(row, {"map", entry.map.array});
  }
  const char* const statistics[] = {"min", "p5", "median", "p95", "max", "area_mean"};
  for (std::size_t i = 0; i < std::size(statistics); ++i) overall.tell(i + 1, statistics[i]);
  // Columns by region: all maps but companions.
  std::vector<std::string> head = {"Region"};
  std::vector<const pipeline::CaseMap*> shown;
  for (const pipeline::CaseMap& entry : result.studied().maps.maps) {
    if (entry.map.companion) continue;
    shown.push_back(&entry);
    head.push_back(with_unit(entry.map));
  }
  head.push_back("area [dm²]");
  // Regions that the garment does not cover have no area and no row.
  Table regions(head);
  regions.make_sortable("regions");
  regions.define(0, "region");
  for (std::size_t i = 0; i < shown.size(); ++i) {
    regions.define(i + 1, shown[i]->map.array);
    regions.tell(i + 1, shown[i]->map.array);
  }
  for (body::Region region : body::all_regions()) {
    std::vector<std::string> row = {spaced(body::name(region))};
    double area = 0;
    for (const pipeline::CaseMap* entry : shown) {
      const auto found = entry->regional.find(region);
      const bool has = found != entry->regional.end();
      row.push_back(has ? value_text(entry->map, found->second.median) + " (" +
                              value_text(entry->map, found->second.p5) + " … " +
                              value_text(entry->map, found->second.p95) + ")"
                        : "–");
      if (has) area = std::max(area, found->second.area);
    }
    row.push_back(fixed(100 * area, 1));
    if (area > 0) regions.add(row, {"region", body::name(region)});
  }
  std::string html = element("h2", "Numbers") + overall.html();
  html += element("h3", "By region of the body: median (5 % … 95 %)") + regions.html();
  if (shows(shown, "strain_max"))
    html += element(
        "p",
        "A lead along a yarn feels the strain along warp or weft; above zero it is stretched. The "
        "greatest principal strain of woven cloth is mostly shear at 45° to the yarns, about "
        "tan(φ/2) of the shear angle φ, and no elongation that such a lead feels.");
  return html +
         element(
             "p",
             "Maps are smoothed: every point has the mean of the triangles round it. What single "
             "triangles reach stands under \u201cDoes it hang?\u201d. All statistics of maps are "
             "weighted by flat cloth area. Left and right are the wearer's.");
}

std::string site_section(const pipeline::CaseResult& result) {
  if (result.sites.empty() || result.studied().maps.maps.empty()) return {};
  std::vector<std::string> head = {"Site", "panel", "u [mm]", "v [mm]", "sensor", "region"};
  const std::size_t first = head.size();
  std::vector<const maps::PerformanceMap*> shown;
  for (const pipeline::CaseMap& entry : result.studied().maps.maps) {
    if (entry.map.companion) continue;
    shown.push_back(&entry.map);
    head.push_back(with_unit(entry.map));
  }
  // The turns of a sensor have no map: a map has none of its three axes.
  const char* const turns[] = {"coe_across_deg", "coe_along_deg", "coe_normal_deg"};
  const bool turned = std::any_of(result.sites.begin(), result.sites.end(), [&](const auto& site) {
    return site.metrics().count(turns[0]) > 0;
  });
  if (turned)
    head.insert(head.end(), {"turn across [deg]", "turn along [deg]", "turn about normal [deg]"});
  Table table(head);
  table.make_sortable("sites");
  table.define(2, "uv");
  table.define(3, "uv");
  table.define(4, "footprint");
  table.define(5, "region");
  for (std::size_t i = 0; i < shown.size(); ++i) {
    table.define(first + i, shown[i]->array);
    table.tell(first + i, shown[i]->array);
  }
  for (std::size_t i = 0; turned && i < std::size(turns); ++i) {
    table.define(first + shown.size() + i, "turns");
    table.tell(first + shown.size() + i, turns[i]);
  }
  for (const placement::Site& site : result.sites) {
    std::vector<std::string> row = {spaced(site.name),
                                    spaced(site.panel),
                                    fixed(1000 * site.at.x(), 0),
                                    fixed(1000 * site.at.y(), 0),
                                    in_words(site.shape),
                                    spaced(body::name(site.region))};
    const std::map<std::string, double> values = pipeline::site_values(site);
    const auto value_of = [&](const std::string& name) {
      const auto found = values.find(name);
      return found == values.end() ? std::nan("") : found->second;
    };
    for (const maps::PerformanceMap* map : shown)
      row.push_back(value_text(*map, value_of(map->array)));
    if (turned)
      for (const char* turn : turns) row.push_back(fixed(value_of(turn), 1));
    table.add(row, {"site", spaced(site.name)});
  }
  std::string bare;
  for (const placement::UncoveredSite& site : result.uncovered_sites)
    if (!site.preset)
      bare += element("li", escaped(site.name + " is not covered by the garment: " + site.why));
  for (const placement::Site& site : result.sites)
    if (!site.not_covering.empty())
      bare += element("li", escaped(site.name + " has no skin under it: " + site.not_covering));
  return element("h2", "Sensor sites") + table.html() +
         (bare.empty() ? bare : element("ul", bare)) +
         element("p",
                 defined("Under a sensor", "footprint") +
                     " as one piece where it has such a value (turns, gap, pressure, strain along "
                     "its axis: the figures that it is judged by, medians over the donnings), else "
                     "the mean of the map over its footprint. u runs along the weft, v along the "
                     "warp of the flat panel.");
}

}  // namespace loosefit::report
