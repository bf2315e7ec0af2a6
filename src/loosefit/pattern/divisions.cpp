#include "loosefit/pattern/divisions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "loosefit/base/error.h"
#include "loosefit/pattern/hole.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/pattern_check.h"
#include "loosefit/pattern/self_crossing.h"

namespace loosefit::pattern {
namespace {

constexpr int kMostDivisions = 20000;  // of one edge
constexpr double kMostVertices = 4e6;  // of the whole mesh

/// Whether a mesh can fill the divided outline. Holes that meet as divided are refused by
/// mesh_panel: more points of the outline do not part them.
bool usable(const Panel& panel, const std::vector<int>& divisions, double edge_length) {
  const std::vector<Vec2> polygon = divided_outline(panel, divisions);
  return polygon.size() >= 3 && signed_area(polygon) > 0 &&
         first_self_crossing(polygon).first < 0 &&
         std::all_of(panel.holes.begin(), panel.holes.end(), [&](const PanelHole& hole) {
           return hole_place_fault({hole.name, divided_hole(hole, edge_length).points}, polygon, {})
               .empty();
         });
}

/// Corners that the seams bring together, as one number each: [panel][vertex].
std::vector<std::vector<int>> sewn_corners(const Pattern& pattern) {
  std::vector<std::vector<int>> corner;
  int count = 0;
  for (const Panel& panel : pattern.panels) {
    corner.emplace_back();
    for (std::size_t v = 0; v < panel.vertices.size(); ++v) corner.back().push_back(count++);
  }
  const auto join = [&](int a, int b) {
    for (std::vector<int>& of_panel : corner)
      for (int& c : of_panel)
        if (c == std::max(a, b)) c = std::min(a, b);
  };
  for (const Stitch& s : pattern.stitches) {
    const auto& first = corner[s.first.panel];
    const auto& second = corner[s.second.panel];
    const PanelEdge& a = pattern.panels[s.first.panel].edges[s.first.edge];
    const PanelEdge& b = pattern.panels[s.second.panel].edges[s.second.edge];
    join(first[a.start], second[s.right_wrong ? b.start : b.end]);
    join(first[a.end], second[s.right_wrong ? b.end : b.start]);
  }
  return corner;
}

/// Two undivided edges between the same sewn corners would become one mesh edge (both halves of a
/// narrow cuff, say) and close an opening: they get a point in their middle.
void part_coinciding_edges(const Pattern& pattern, std::vector<std::vector<int>>& divisions) {
  const std::vector<std::vector<int>> corner = sewn_corners(pattern);
  std::map<std::pair<int, int>, std::pair<int, int>> partner;
  for (const Stitch& s : pattern.stitches) {
    partner[{s.first.panel, s.first.edge}] = {s.second.panel, s.second.edge};
    partner[{s.second.panel, s.second.edge}] = {s.first.panel, s.first.edge};
  }
  std::map<std::pair<int, int>, std::vector<std::pair<int, int>>> between;  // corners → edges
  for (int p = 0; p < static_cast<int>(pattern.panels.size()); ++p)
    for (int e = 0; e < static_cast<int>(pattern.panels[p].edges.size()); ++e) {
      const PanelEdge& edge = pattern.panels[p].edges[e];
      if (divisions[p][e] == 1)
        between[std::minmax(corner[p][edge.start], corner[p][edge.end])].push_back({p, e});
    }
  for (const auto& [corners, edges] : between) {
    const bool one_seam =
        edges.size() == 2 && partner.contains(edges[0]) && partner.at(edges[0]) == edges[1];
    if (edges.size() < 2 || one_seam) continue;
    for (const auto& [p, e] : edges) divisions[p][e] = 2;
  }
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
  return edge_divisions(pattern, std::vector<double>(pattern.panels.size(), edge_length));
}

std::vector<std::vector<int>> edge_divisions(const Pattern& pattern,
                                             const std::vector<double>& wanted) {
  const InputPlace place{{}, 0, "edge_length"};
  for (const double edge : wanted)
    if (!(edge > 0) || !std::isfinite(edge))
      throw InvalidInput(place, fmt::format("{:.6g} m", edge), "a positive length in metres");
  check_pattern(pattern);

  // Each edge by its own length, refused before memory runs out.
  std::vector<std::vector<int>> divisions;
  double area = 0, vertices = 0;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const Panel& panel = pattern.panels[p];
    const double here = signed_area(outline_polygon(panel));
    area += here;
    vertices += here / (0.87 * wanted[p] * wanted[p]);
    std::vector<int> counts;
    for (const double length : edge_lengths(panel)) {
      const double count = std::round(length / wanted[p]);
      if (count > kMostDivisions)
        throw InvalidInput(place, fmt::format("{:.6g} m", wanted[p]),
                           fmt::format("at least {:.3g} m for an edge of {:.3g} m in panel {}",
                                       length / kMostDivisions, length, panel.name));
      counts.push_back(std::max(1, static_cast<int>(count)));
    }
    divisions.push_back(counts);
  }
  const double finest = *std::min_element(wanted.begin(), wanted.end());
  if (vertices > kMostVertices)
    throw InvalidInput(place, fmt::format("{:.6g} m", finest),
                       fmt::format("at least {:.3g} m for a garment of {:.3g} m²",
                                   finest * std::sqrt(vertices / kMostVertices), area));

  // Both sides of a seam take the larger count.
  const auto join = [&](const Stitch& s) {
    int& first = divisions[s.first.panel][s.first.edge];
    int& second = divisions[s.second.panel][s.second.edge];
    first = second = std::max(first, second);
  };
  for (const Stitch& s : pattern.stitches) join(s);
  part_coinciding_edges(pattern, divisions);
  // Coarsely divided narrow or strongly curved pieces may cross themselves: double their counts.
  for (int round = 0; round < 12; ++round) {
    bool changed = false;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
      if (usable(pattern.panels[p], divisions[p], wanted[p])) continue;
      changed = true;
      for (std::size_t e = 0; e < divisions[p].size(); ++e) divisions[p][e] *= 2;
    }
    if (!changed) return divisions;
    for (const Stitch& s : pattern.stitches) join(s);
  }
  throw GeometryError(place, fmt::format("{:.6g} m", finest),
                      "an edge length at which every outline stays simple",
                      "a panel is extremely narrow; check the pattern");
}

}  // namespace loosefit::pattern
