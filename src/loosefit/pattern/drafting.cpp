#include "loosefit/pattern/drafting.h"

#include "loosefit/pattern/outline.h"

namespace loosefit::pattern {

Panel draft_panel(const std::string& name, const std::string& label,
                  const std::vector<std::pair<std::string, CurveChain>>& loop) {
  Panel panel;
  panel.name = panel.part = name;
  panel.label = label;
  const int n = static_cast<int>(loop.size());
  for (int i = 0; i < n; ++i) {
    const auto& [edge_name, chain] = loop[i];
    panel.vertices.push_back(chain.start);
    PanelEdge edge;
    edge.start = i;
    edge.end = (i + 1) % n;
    edge.curves = chain.curves;
    edge.knots.assign(chain.knots.begin(), chain.knots.end() - 1);
    edge.name = edge.part = edge_name;
    panel.edges.push_back(edge);
  }
  return panel;
}

void sew_edges(Pattern& pattern, const std::string& name, const std::string& panel_a,
               const std::string& edge_a, const std::string& panel_b, const std::string& edge_b) {
  Stitch stitch;
  stitch.name = name;
  stitch.first.panel = pattern.find_panel(panel_a);
  stitch.first.edge = find_edge(pattern.panels[stitch.first.panel], edge_a);
  stitch.second.panel = pattern.find_panel(panel_b);
  stitch.second.edge = find_edge(pattern.panels[stitch.second.panel], edge_b);
  pattern.stitches.push_back(stitch);
}

}  // namespace loosefit::pattern
