#include "loosefit/drape/panel_roles.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "loosefit/geometry/box.h"

namespace loosefit::drape {
namespace {

bool names_a_sleeve(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name.find("sleeve") != std::string::npos;
}

bool is_arm(kinds::OpeningUse use) {
  return use == kinds::OpeningUse::left_arm || use == kinds::OpeningUse::right_arm;
}

}  // namespace

std::vector<PanelRole> panel_roles(const garment::OpenSeams& open, const pattern::Pattern& pattern,
                                   const std::vector<Opening>& openings,
                                   const std::vector<Vec3>& placed) {
  const garment::Garment& g = open.garment;
  const std::size_t panels = g.panel_names.size();
  // Which openings and which other panels each panel reaches.
  std::set<int> at_arm, elsewhere;
  for (const Opening& o : openings)
    (is_arm(o.use) ? at_arm : elsewhere).insert(o.loop.begin(), o.loop.end());
  std::vector<char> arm_opening(panels, 0), other_opening(panels, 0);
  std::vector<double> x(panels, 0), count(panels, 0);
  geometry::Box3 box;
  for (int v = 0; v < g.vertex_count; ++v) {
    const int k = g.vertex_panel[v];
    if (at_arm.count(open.sewn[v])) arm_opening[k] = 1;
    if (elsewhere.count(open.sewn[v])) other_opening[k] = 1;
    x[k] += placed[v].x(), ++count[k];
    box.extend(placed[v]);
  }
  std::vector<std::set<int>> sewn_to(panels);
  for (const std::vector<int>& of : open.partners)
    for (int a : of)
      for (int b : of)
        if (g.vertex_panel[a] != g.vertex_panel[b])
          sewn_to[g.vertex_panel[a]].insert(g.vertex_panel[b]);

  std::vector<char> arm(panels, 0);
  bool labelled = false;
  for (const pattern::Panel& panel : pattern.panels) labelled = labelled || panel.label == "arm";
  for (std::size_t k = 0; k < panels; ++k) {
    const pattern::Panel& panel = pattern.panels[pattern.find_panel(g.panel_names[k])];
    arm[k] = !panel.label.empty()
                 ? panel.label == "arm"
                 : names_a_sleeve(panel.name) || (!labelled && arm_opening[k] && !other_opening[k]);
  }
  // What is sewn to arms and trunk without an opening of its own is an arm's if it lies farther out
  // than half of the way; what is sewn to arms only is one in any case.
  const double middle = 0.5 * (box.min().x() + box.max().x());
  for (bool grown = !labelled; grown;) {
    grown = false;
    for (std::size_t k = 0; k < panels; ++k) {
      if (arm[k] || other_opening[k] || sewn_to[k].empty()) continue;
      const auto arms =
          std::count_if(sewn_to[k].begin(), sewn_to[k].end(), [&](int o) { return arm[o]; });
      const bool out = std::abs(x[k] / count[k] - middle) > 0.5 * (box.max().x() - middle);
      if (arms == static_cast<long>(sewn_to[k].size()) || (arms > 0 && out)) arm[k] = grown = true;
    }
  }
  std::vector<PanelRole> roles(panels, PanelRole::trunk);
  for (std::size_t k = 0; k < panels; ++k)
    if (arm[k]) roles[k] = x[k] / count[k] > middle ? PanelRole::left_arm : PanelRole::right_arm;
  return roles;
}

}  // namespace loosefit::drape
