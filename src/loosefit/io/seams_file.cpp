#include "loosefit/io/seams_file.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/config_reader.h"
#include "loosefit/io/text_file.h"
#include "loosefit/io/toml_file.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::io {
namespace {

constexpr double kGathered = 0.1;  // difference of lengths that is told, of the longer side
constexpr std::size_t kLargestFile = 1 << 20;

/// "PANEL.EDGE"; names of panels may have dots, names of edges of such files have none.
pattern::Stitch::Side read_side(ConfigReader& seam, const std::string& key,
                                const pattern::Pattern& pattern,
                                std::set<std::pair<int, int>>& sewn) {
  const std::string text = seam.text(key, "");
  const std::size_t dot = text.rfind('.');
  if (text.empty() || dot == std::string::npos)
    throw seam.error(key, "a panel and an edge, \"FRONT.e1\"");
  pattern::Stitch::Side side;
  const std::string panel_name = text.substr(0, dot), edge_name = text.substr(dot + 1);
  std::vector<std::string> names;
  for (const pattern::Panel& panel : pattern.panels) names.push_back(panel.name);
  side.panel = pattern.find_panel(panel_name);
  if (side.panel < 0)
    throw seam.error(key, "a panel of the pattern", did_you_mean(panel_name, names));
  const pattern::Panel& panel = pattern.panels[side.panel];
  names.clear();
  for (const pattern::PanelEdge& edge : panel.edges) names.push_back(edge.name);
  side.edge = pattern::find_edge(panel, edge_name);
  if (side.edge < 0)
    throw seam.error(key, "an edge of panel " + printable(panel.name),
                     did_you_mean(edge_name, names));
  if (!sewn.insert({side.panel, side.edge}).second)
    throw seam.error(key, "an edge that is not sewn yet", "each edge is in at most one seam");
  return side;
}

}  // namespace

std::filesystem::path seams_path(const std::filesystem::path& pattern_file) {
  std::filesystem::path path = pattern_file;
  return path.replace_extension(".seams.toml");
}

void parse_seams(const std::string& text, const std::string& file, pattern::Pattern& pattern,
                 std::vector<std::string>& warnings) {
  const ConfigNode root = parse_toml(text, file);
  ConfigReader reader(root, file);
  reader.only({"seam"});
  std::set<std::pair<int, int>> sewn;
  for (const pattern::Stitch& stitch : pattern.stitches)
    for (const auto& side : {stitch.first, stitch.second}) sewn.insert({side.panel, side.edge});
  std::set<std::string> names;
  for (ConfigReader& seam : reader.tables("seam")) {
    seam.only({"first", "second", "reversed", "name"});
    pattern::Stitch stitch;
    stitch.first = read_side(seam, "first", pattern, sewn);
    stitch.second = read_side(seam, "second", pattern, sewn);
    stitch.right_wrong = seam.boolean("reversed", false);
    stitch.name = seam.text("name", fmt::format("seam_{}", pattern.stitches.size() + 1));
    if (!names.insert(stitch.name).second)
      throw seam.error("name", "a name that no other seam has");
    seam.finish();
    const auto length = [&](const pattern::Stitch::Side& side) {
      return pattern::EdgePath(pattern.panels[side.panel], side.edge).length();
    };
    const double a = length(stitch.first), b = length(stitch.second);
    if (std::abs(a - b) > kGathered * std::max(a, b))
      warnings.push_back(fmt::format(
          "seam {}: its sides are {:.1f} and {:.1f} mm long, the longer one is gathered",
          printable(stitch.name), 1000 * a, 1000 * b));
    pattern.stitches.push_back(std::move(stitch));
  }
  reader.finish();
}

void read_seams(const std::filesystem::path& path, pattern::Pattern& pattern,
                std::vector<std::string>& warnings) {
  parse_seams(read_text_file(path.string(), kLargestFile), path.string(), pattern, warnings);
}

}  // namespace loosefit::io
