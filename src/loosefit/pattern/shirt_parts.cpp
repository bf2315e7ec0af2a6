#include "loosefit/pattern/shirt_parts.h"

#include <map>

#include "loosefit/pattern/outline.h"

namespace loosefit {
namespace {

using Place = std::pair<int, int>;  // panel, edge

/// Every sewn edge with the one it is sewn to.
std::map<Place, Place> sewn_edges(const Pattern& pattern) {
  std::map<Place, Place> sewn;
  for (const Stitch& s : pattern.stitches) {
    const Place a{s.first.panel, s.first.edge}, b{s.second.panel, s.second.edge};
    sewn[a] = b;
    sewn[b] = a;
  }
  return sewn;
}

/// Edges of one panel in the order of the draft, counted from a certain one.
struct Turn {
  int panel = -1, first = 0, count = 0;
  Place at(int k) const { return {panel, (first + k) % count}; }
};

class ShirtParts {
 public:
  explicit ShirtParts(const Pattern& pattern) : pattern_(pattern), sewn_(sewn_edges(pattern)) {}

  /// Parts of all panels and edges; empty when it is no shirt.
  std::map<Place, std::string> edges;
  std::map<int, std::string> panels;

  bool find() {
    if (pattern_.panels.size() != 6 || pattern_.stitches.size() != 12) return false;
    for (const Stitch& s : pattern_.stitches)
      if (s.right_wrong) return false;
    std::vector<Turn> torso;
    for (int p = 0; p < 6; ++p) {
      const std::size_t count = pattern_.panels[p].edges.size();
      if (count != 8 && count != 4) return false;
      if (count == 8) torso.push_back(from_hem(p));
    }
    if (torso.size() != 2 || torso[0].panel < 0 || torso[1].panel < 0) return false;
    const auto outside = [&](const Turn& t) { return pattern_.panels[t.panel].rotation(1, 2); };
    if (outside(torso[1]) < outside(torso[0])) std::swap(torso[0], torso[1]);  // we face -y
    const Turn &front = torso[0], &back = torso[1];
    if (!together(front.at(1), back.at(7)) || !together(front.at(7), back.at(1)) ||
        !together(front.at(3), back.at(5)) || !together(front.at(5), back.at(3)))
      return false;
    note_torso(front, "front", "L", "R");
    note_torso(back, "back", "R", "L");
    return note_sleeve(front.at(2), "sleeve_L_front", true) &&
           note_sleeve(front.at(6), "sleeve_R_front", false) &&
           note_sleeve(back.at(2), "sleeve_R_back", true) &&
           note_sleeve(back.at(6), "sleeve_L_back", false) && panels.size() == 6 &&
           sleeves_closed("L") && sleeves_closed("R");
  }

 private:
  bool together(const Place& a, const Place& b) const {
    const auto found = sewn_.find(a);
    return found != sewn_.end() && found->second == b;
  }
  double height(const Place& edge) const {
    return EdgePath(pattern_.panels[edge.first], edge.second).at(0.5).y();
  }

  /// Counted from the lower of two free edges that face each other.
  Turn from_hem(int panel) const {
    std::vector<int> free;
    for (int e = 0; e < 8; ++e)
      if (!sewn_.count({panel, e})) free.push_back(e);
    if (free.size() != 2 || free[1] - free[0] != 4) return {};
    const bool first = height({panel, free[0]}) < height({panel, free[1]});
    return {panel, first ? free[0] : free[1], 8};
  }

  void note_torso(const Turn& turn, const std::string& name, const std::string& first_side,
                  const std::string& second_side) {
    panels[turn.panel] = name;
    const std::string parts[8] = {
        "hem",  "side_" + first_side,      "armhole_" + first_side,  "shoulder_" + first_side,
        "neck", "shoulder_" + second_side, "armhole_" + second_side, "side_" + second_side};
    for (int k = 0; k < 8; ++k) edges[turn.at(k)] = parts[k];
  }

  /// rising: the armhole edge runs up to the shoulder, so that the cap runs down from it.
  bool note_sleeve(const Place& armhole, const std::string& name, bool rising) {
    const auto cap = sewn_.find(armhole);
    if (cap == sewn_.end()) return false;
    const int panel = cap->second.first;
    if (pattern_.panels[panel].edges.size() != 4 || panels.count(panel)) return false;
    const Turn turn{panel, cap->second.second, 4};
    if (sewn_.count(turn.at(2))) return false;
    panels[panel] = name;
    edges[turn.at(0)] = "cap";
    edges[turn.at(1)] = rising ? "under" : "top";
    edges[turn.at(2)] = "cuff";
    edges[turn.at(3)] = rising ? "top" : "under";
    return true;
  }

  Place place_of(const std::string& panel, const std::string& edge) const {
    for (const auto& [place, part] : edges)
      if (part == edge && panels.at(place.first) == panel) return place;
    return {-1, -1};
  }
  bool sleeves_closed(const std::string& side) const {
    for (const char* edge : {"top", "under"})
      if (!together(place_of("sleeve_" + side + "_front", edge),
                    place_of("sleeve_" + side + "_back", edge)))
        return false;
    return true;
  }

  const Pattern& pattern_;
  const std::map<Place, Place> sewn_;
};

}  // namespace

bool note_shirt_parts(Pattern& pattern) {
  ShirtParts parts(pattern);
  if (!parts.find()) return false;
  for (const auto& [panel, part] : parts.panels) pattern.panels[panel].part = part;
  for (const auto& [place, part] : parts.edges)
    pattern.panels[place.first].edges[place.second].part = part;
  return true;
}

bool has_shirt_parts(const Pattern& pattern) {
  Pattern noted = pattern;
  if (!note_shirt_parts(noted)) return false;
  for (std::size_t p = 0; p < noted.panels.size(); ++p) {
    if (noted.panels[p].part != pattern.panels[p].part) return false;
    for (std::size_t e = 0; e < noted.panels[p].edges.size(); ++e)
      if (noted.panels[p].edges[e].part != pattern.panels[p].edges[e].part) return false;
  }
  return true;
}

bool called_like_shirt_parts(const Pattern& pattern) {
  for (const Panel& panel : pattern.panels) {
    if (panel.part.empty() || panel.name != panel.part) return false;
    for (const PanelEdge& edge : panel.edges)
      if (edge.name != edge.part) return false;
  }
  return true;
}

}  // namespace loosefit
