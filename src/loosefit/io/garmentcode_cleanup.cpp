#include "loosefit/io/garmentcode_cleanup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/io/garmentcode_frame.h"
#include "loosefit/pattern/curve.h"
#include "loosefit/pattern/hole.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::io {

void close_loops(pattern::Pattern& pattern) {
  constexpr double kSamePlace = 1e-6;  // [m]; files close to 4e-15 m
  for (pattern::Panel& panel : pattern.panels) {
    const std::size_t n = panel.edges.size();
    for (std::size_t e = 0; e < n; ++e) {
      pattern::PanelEdge& edge = panel.edges[e];
      const pattern::PanelEdge& next = panel.edges[(e + 1) % n];
      const std::string name = edge.name.empty() ? std::to_string(e) : edge.name;
      if (edge.start == edge.end)
        throw GeometryError(InputPlace{{}, 0, fmt::format("panel {} edge {}", panel.name, name)},
                            fmt::format("start and end at vertex {}", edge.start),
                            "two different vertices");
      if (edge.end == next.start) continue;
      if ((panel.vertices[edge.end] - panel.vertices[next.start]).norm() > kSamePlace)
        throw GeometryError(InputPlace{{}, 0, fmt::format("panel {} edge {}", panel.name, name)},
                            fmt::format("end at vertex {}", edge.end),
                            fmt::format("vertex {}, where the next edge starts", next.start),
                            "the edges of a panel form one closed loop in list order");
      edge.end = next.start;
    }
  }
}

void make_counter_clockwise(pattern::Panel& panel) {
  if (!(pattern::signed_area(pattern::outline_polygon(panel)) < 0)) return;
  for (Vec2& v : panel.vertices) v.x() = -v.x();
  for (pattern::PanelEdge& edge : panel.edges) {
    for (Vec2& k : edge.knots) k.x() = -k.x();
    for (pattern::EdgeCurve& curve : edge.curves) curve = pattern::mirrored_curve(curve);
  }
  panel.holes = pattern::mirrored_holes(std::move(panel.holes));
  const Mat3 half_turn = Vec3(-1, 1, -1).asDiagonal();
  panel.rotation = panel.rotation * half_turn;
}

void set_panel_order(pattern::Pattern& pattern, const std::vector<std::string>& names) {
  constexpr double kEqual = 0.10;  // [m]
  pattern.panel_order.clear();
  const auto listed = [&](int p) {
    return std::find(pattern.panel_order.begin(), pattern.panel_order.end(), p) !=
           pattern.panel_order.end();
  };
  for (const std::string& name : names)
    if (const int p = pattern.find_panel(name); p >= 0 && !listed(p))
      pattern.panel_order.push_back(p);

  std::vector<std::pair<int, Vec3>> rest;
  for (int p = 0; p < static_cast<int>(pattern.panels.size()); ++p) {
    if (listed(p)) continue;
    const pattern::Panel& panel = pattern.panels[p];
    Vec3 low = Vec3::Constant(1e9), high = -low;
    for (const Vec2& v : panel.vertices) {
      const Vec3 at = frame_from_y_up().transpose() *
                      (panel.rotation * Vec3(v.x(), v.y(), 0) + panel.translation);
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
    rest.push_back({p, {(low.x() + high.x()) / 2, high.y(), (low.z() + high.z()) / 2}});
  }
  // "Equal within 10 cm" is no ordering (it is not transitive), so values are put into classes:
  // sorted, a new class begins where the gap to the class's first value reaches 10 cm.
  std::vector<std::array<int, 3>> classes(rest.size());
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<std::size_t> order(rest.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return rest[a].second[axis] < rest[b].second[axis];
    });
    int current = 0;
    double begin = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const double value = rest[order[i]].second[axis];
      if (i == 0) begin = value;
      if (value - begin >= kEqual) ++current, begin = value;
      classes[order[i]][axis] = current;
    }
  }
  std::vector<std::size_t> order(rest.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return classes[a] < classes[b]; });
  for (const std::size_t i : order) pattern.panel_order.push_back(rest[i].first);
}

}  // namespace loosefit::io
