#pragma once
#include "loosefit/pattern/pattern.h"

namespace loosefit::testing_support {

/// Panel from corners (counter-clockwise) with straight edges named edge_0, edge_1, …; edge i runs
/// from corner i to corner i + 1.
inline pattern::Panel polygon_panel(const std::string& name, const std::vector<Vec2>& corners) {
  pattern::Panel panel;
  panel.name = name;
  panel.vertices = corners;
  const int n = static_cast<int>(corners.size());
  for (int i = 0; i < n; ++i) {
    pattern::PanelEdge edge;
    edge.start = i;
    edge.end = (i + 1) % n;
    edge.name = "edge_" + std::to_string(i);
    panel.edges.push_back(edge);
  }
  return panel;
}

/// Axis-aligned rectangle from the origin: edge_0 bottom, edge_1 right, edge_2 top, edge_3 left.
inline pattern::Panel rectangle_panel(const std::string& name, double width, double height) {
  return polygon_panel(name, {{0, 0}, {width, 0}, {width, height}, {0, height}});
}

inline pattern::Stitch stitch(int panel_a, int edge_a, int panel_b, int edge_b,
                              bool right_wrong = false) {
  pattern::Stitch s;
  s.first = {panel_a, edge_a};
  s.second = {panel_b, edge_b};
  s.right_wrong = right_wrong;
  s.name = "seam";
  return s;
}

}  // namespace loosefit::testing_support
