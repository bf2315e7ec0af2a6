#include "loosefit/pattern/divisions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "loosefit/base/error.h"
#include "loosefit/pattern/outline.h"

namespace loosefit {
namespace {

constexpr int kMostDivisions = 20000;  // of one edge
constexpr double kMostVertices = 4e6;  // of the whole mesh

bool usable(const std::vector<Vec2>& polygon) {
  return polygon.size() >= 3 && signed_area(polygon) > 0 && first_self_crossing(polygon).first < 0;
}

}  // namespace

std::vector<Vec2> divided_outline(const Panel& panel, const std::vector<int>& divisions) {
  std::vector<Vec2> points;
  for (std::size_t e = 0; e < panel.edges.size(); ++e) {
    const EdgePath path(panel, static_cast<int>(e));
    for (int i = 0; i < divisions[e]; ++i) points.push_back(path.at(double(i) / divisions[e]));
  }
  return points;
}

std::vector<std::vector<int>> edge_divisions(const Pattern& pattern, double edge_length) {
  const InputPlace place{{}, 0, "edge_length"};
  if (!(edge_length > 0) || !std::isfinite(edge_length))
    throw InvalidInput(place, fmt::format("{:.6g} m", edge_length), "a positive length in metres");
  check_pattern(pattern);

  std::vector<std::vector<int>> divisions;
  double area = 0;
  for (const Panel& panel : pattern.panels) {
    area += signed_area(outline_polygon(panel));
    std::vector<int> counts;
    for (const double length : edge_lengths(panel)) {
      const double count = std::round(length / edge_length);
      if (count > kMostDivisions)
        throw InvalidInput(place, fmt::format("{:.6g} m", edge_length),
                           fmt::format("at least {:.3g} m for an edge of {:.3g} m in panel {}",
                                       length / kMostDivisions, length, panel.name));
      counts.push_back(std::max(1, static_cast<int>(count)));
    }
    divisions.push_back(counts);
  }
  if (area / (0.87 * edge_length * edge_length) > kMostVertices)
    throw InvalidInput(place, fmt::format("{:.6g} m", edge_length),
                       fmt::format("at least {:.3g} m for a garment of {:.3g} m²",
                                   std::sqrt(area / 0.87 / kMostVertices), area));

  std::map<std::pair<int, int>, std::pair<int, int>> partner;
  const auto join = [&](const Stitch& s) {
    int& a = divisions[s.first.panel][s.first.edge];
    int& b = divisions[s.second.panel][s.second.edge];
    a = b = std::max(a, b);
  };
  for (const Stitch& s : pattern.stitches) {
    join(s);
    partner[{s.first.panel, s.first.edge}] = {s.second.panel, s.second.edge};
    partner[{s.second.panel, s.second.edge}] = {s.first.panel, s.first.edge};
  }
  // Coarsely divided narrow or strongly curved pieces may cross themselves: double their counts.
  for (int round = 0; round < 12; ++round) {
    bool changed = false;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
      if (usable(divided_outline(pattern.panels[p], divisions[p]))) continue;
      changed = true;
      for (std::size_t e = 0; e < divisions[p].size(); ++e) divisions[p][e] *= 2;
    }
    if (!changed) return divisions;
    for (const Stitch& s : pattern.stitches) join(s);
  }
  throw GeometryError(place, fmt::format("{:.6g} m", edge_length),
                      "an edge length at which every outline stays simple",
                      "a panel is extremely narrow; check the pattern");
}

}  // namespace loosefit
