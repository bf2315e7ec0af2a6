#include "loosefit/kinds/match_parts.h"

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "loosefit/pattern/outline.h"

namespace loosefit::kinds {
namespace {

using Place = std::pair<int, int>;  // panel, edge

/// Every sewn edge with the one it is sewn to.
std::map<Place, Place> sewn_edges(const pattern::Pattern& pattern) {
  std::map<Place, Place> sewn;
  for (const pattern::Stitch& s : pattern.stitches) {
    const Place a{s.first.panel, s.first.edge}, b{s.second.panel, s.second.edge};
    sewn[a] = b;
    sewn[b] = a;
  }
  return sewn;
}

int edges_of(const pattern::Pattern& pattern, int panel) {
  return static_cast<int>(pattern.panels[panel].edges.size());
}

/// Per panel of the draft: the panel it maps to and by how much its edges are counted on.
struct Turn {
  int panel = -1, shift = 0;
};
using Match = std::vector<Turn>;

Place image(const Match& match, const pattern::Pattern& pattern, const Place& edge) {
  const Turn& turn = match[edge.first];
  return {turn.panel, (edge.second + turn.shift) % edges_of(pattern, turn.panel)};
}

/// The map that follows from where the first panel goes: seam by seam.
std::optional<Match> grow(const pattern::Pattern& draft, const std::map<Place, Place>& draft_sewn,
                          const pattern::Pattern& pattern, const std::map<Place, Place>& sewn,
                          Turn first) {
  Match match(draft.panels.size());
  std::vector<char> used(pattern.panels.size(), 0);
  std::vector<int> open;
  const auto set = [&](int panel, const Turn& to) {
    if (used[to.panel] || edges_of(draft, panel) != edges_of(pattern, to.panel)) return false;
    match[panel] = to;
    used[to.panel] = 1;
    open.push_back(panel);
    return true;
  };
  if (!set(0, first)) return {};
  while (!open.empty()) {
    const int panel = open.back();
    open.pop_back();
    for (int e = 0; e < edges_of(draft, panel); ++e) {
      const auto there = draft_sewn.find({panel, e});
      const auto here = sewn.find(image(match, pattern, {panel, e}));
      // Free edges are free in both.
      if ((there == draft_sewn.end()) != (here == sewn.end())) return {};
      if (there == draft_sewn.end()) continue;
      const auto& [other, other_edge] = there->second;
      const auto& [to, to_edge] = here->second;
      const int n = edges_of(pattern, to);
      if (match[other].panel < 0 && !set(other, {to, ((to_edge - other_edge) % n + n) % n}))
        return {};
      if (image(match, pattern, there->second) != here->second) return {};
    }
  }
  const bool whole =
      std::all_of(match.begin(), match.end(), [](const Turn& t) { return t.panel >= 0; });
  return whole ? std::optional(match) : std::nullopt;
}

/// Middles of the edges about that of the panel, in units of the panel's size.
std::vector<Vec2> edge_middles(const pattern::Panel& panel) {
  std::vector<Vec2> middles;
  Vec2 low = panel.vertices.front(), high = low;
  for (const Vec2& p : panel.vertices) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double size = std::max(1e-9, 0.5 * (high - low).norm());
  for (int e = 0; e < static_cast<int>(panel.edges.size()); ++e)
    middles.push_back((pattern::EdgePath(panel, e).at(0.5) - 0.5 * (low + high)) / size);
  return middles;
}

/// How alike the panels lie: normals look the same way, edges are at the same places.
double likeness(const pattern::Pattern& draft, const pattern::Pattern& pattern,
                const Match& match) {
  double sum = 0;
  for (int p = 0; p < static_cast<int>(match.size()); ++p) {
    const pattern::Panel &a = draft.panels[p], &b = pattern.panels[match[p].panel];
    sum += a.rotation.col(2).dot(b.rotation.col(2));
    const std::vector<Vec2> at_a = edge_middles(a), at_b = edge_middles(b);
    const std::size_t n = at_a.size();
    for (std::size_t e = 0; e < n; ++e)
      sum += at_a[e].dot(at_b[(e + match[p].shift) % n]) / static_cast<double>(n);
  }
  return sum;
}

}  // namespace

bool match_parts(const pattern::Pattern& draft, pattern::Pattern& pattern) {
  if (pattern.panels.size() != draft.panels.size() ||
      pattern.stitches.size() != draft.stitches.size() ||
      std::any_of(pattern.stitches.begin(), pattern.stitches.end(),
                  [](const pattern::Stitch& s) { return s.right_wrong; }))
    return false;
  const auto draft_sewn = sewn_edges(draft), sewn = sewn_edges(pattern);
  std::optional<Match> best;
  double best_likeness = 0;
  for (int p = 0; p < static_cast<int>(pattern.panels.size()); ++p)
    for (int shift = 0; shift < edges_of(pattern, p); ++shift) {
      const std::optional<Match> match = grow(draft, draft_sewn, pattern, sewn, {p, shift});
      if (!match) continue;
      const double here = likeness(draft, pattern, *match);
      if (!best || here > best_likeness) best = match, best_likeness = here;
    }
  if (!best) return false;
  for (int p = 0; p < static_cast<int>(best->size()); ++p) {
    const Turn& turn = (*best)[p];
    pattern.panels[turn.panel].part = draft.panels[p].part;
    for (int e = 0; e < edges_of(draft, p); ++e)
      pattern.panels[turn.panel].edges[image(*best, pattern, {p, e}).second].part =
          draft.panels[p].edges[e].part;
  }
  return true;
}

}  // namespace loosefit::kinds
