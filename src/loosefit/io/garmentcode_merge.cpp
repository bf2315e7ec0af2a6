#include "loosefit/io/garmentcode_merge.h"

#include <algorithm>
#include <map>
#include <set>

namespace loosefit::io {
namespace {

/// Runs of file edges that belong together, per panel: group number of every edge and its place.
struct Groups {
  std::vector<std::vector<int>> of;                    // [panel][edge] → group within the panel
  std::vector<std::vector<std::vector<int>>> members;  // [panel][group] → edges
};

Groups group_by_name(const pattern::Pattern& pattern,
                     const std::set<std::pair<int, std::string>>& apart) {
  Groups groups;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const pattern::Panel& panel = pattern.panels[p];
    std::vector<int> of;
    std::vector<std::vector<int>> members;
    for (std::size_t e = 0; e < panel.edges.size(); ++e) {
      const std::string& name = panel.edges[e].name;
      const bool goes_on = e > 0 && !name.empty() && name == panel.edges[e - 1].name &&
                           panel.edges[e].elastic == panel.edges[e - 1].elastic &&
                           !apart.contains({static_cast<int>(p), name});
      if (!goes_on) members.emplace_back();
      members.back().push_back(static_cast<int>(e));
      of.push_back(static_cast<int>(members.size()) - 1);
    }
    if (members.size() < 2) {  // a loop of one name only: keep the edges of the file
      members.clear();
      for (std::size_t e = 0; e < panel.edges.size(); ++e) {
        members.push_back({static_cast<int>(e)});
        of[e] = static_cast<int>(e);
      }
    }
    groups.of.push_back(of);
    groups.members.push_back(members);
  }
  return groups;
}

struct SewnTo {
  pattern::Stitch::Side side;
  bool right_wrong = false;
};
using SewnMap = std::map<std::pair<int, int>, SewnTo>;

/// All parts free, or all sewn in order to all parts of one group.
bool group_is_whole(const Groups& groups, const SewnMap& sewn, int panel, int group) {
  const std::vector<int>& parts = groups.members[panel][group];
  const auto first = sewn.find({panel, parts[0]});
  if (first == sewn.end())
    return std::none_of(parts.begin(), parts.end(), [&](int e) {
      return sewn.contains({panel, e});
    });
  const SewnTo& to = first->second;
  const std::vector<int>& others =
      groups.members[to.side.panel][groups.of[to.side.panel][to.side.edge]];
  if (others.size() != parts.size()) return false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto it = sewn.find({panel, parts[i]});
    if (it == sewn.end() || it->second.right_wrong != to.right_wrong ||
        it->second.side.panel != to.side.panel ||
        it->second.side.edge != others[to.right_wrong ? i : parts.size() - 1 - i])
      return false;
  }
  return true;
}

void make_unique(std::string& name, std::set<std::string>& used) {
  std::string candidate = name;
  for (int k = 2; !used.insert(candidate).second; ++k) candidate = name + "_" + std::to_string(k);
  name = candidate;
}

pattern::PanelEdge joined(const pattern::Panel& panel, const std::vector<int>& parts) {
  pattern::PanelEdge edge = panel.edges[parts[0]];
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const pattern::PanelEdge& next = panel.edges[parts[i]];
    edge.knots.push_back(panel.vertices[next.start]);
    edge.curves.insert(edge.curves.end(), next.curves.begin(), next.curves.end());
    edge.end = next.end;
  }
  return edge;
}

}  // namespace

void merge_named_edges(pattern::Pattern& pattern) {
  SewnMap sewn;
  for (const pattern::Stitch& s : pattern.stitches) {
    sewn[{s.first.panel, s.first.edge}] = {s.second, s.right_wrong};
    sewn[{s.second.panel, s.second.edge}] = {s.first, s.right_wrong};
  }
  std::set<std::pair<int, std::string>> apart;
  Groups groups = group_by_name(pattern, apart);
  for (bool again = true; again;) {  // splitting one group may break the one it was sewn to
    again = false;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p)
      for (std::size_t g = 0; g < groups.members[p].size(); ++g) {
        const std::vector<int>& parts = groups.members[p][g];
        if (parts.size() < 2 ||
            group_is_whole(groups, sewn, static_cast<int>(p), static_cast<int>(g)))
          continue;
        again |= apart.insert({static_cast<int>(p), pattern.panels[p].edges[parts[0]].name}).second;
      }
    if (again) groups = group_by_name(pattern, apart);
  }

  std::vector<pattern::Stitch> stitches;
  std::set<std::string> stitch_names;
  for (pattern::Stitch s : pattern.stitches) {
    const int a = groups.of[s.first.panel][s.first.edge];
    const int b = groups.of[s.second.panel][s.second.edge];
    if (groups.members[s.first.panel][a][0] != s.first.edge) continue;  // a later part
    s.first.edge = a;
    s.second.edge = b;
    stitches.push_back(s);
  }
  for (std::size_t s = 0; s < stitches.size(); ++s) {
    if (stitches[s].name.empty()) stitches[s].name = "seam_" + std::to_string(s);
    make_unique(stitches[s].name, stitch_names);
  }
  pattern.stitches = stitches;

  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    pattern::Panel& panel = pattern.panels[p];
    std::vector<pattern::PanelEdge> edges;
    std::set<std::string> names;
    for (const std::vector<int>& parts : groups.members[p]) edges.push_back(joined(panel, parts));
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (edges[e].name.empty()) edges[e].name = "edge_" + std::to_string(e);
      make_unique(edges[e].name, names);
    }
    panel.edges = edges;
    // Vertices that became joints are no corners any more.
    std::vector<int> kept(panel.vertices.size(), -1);
    std::vector<Vec2> vertices;
    for (pattern::PanelEdge& edge : panel.edges) {
      kept[edge.start] = static_cast<int>(vertices.size());
      vertices.push_back(panel.vertices[edge.start]);
    }
    for (pattern::PanelEdge& edge : panel.edges) {
      edge.start = kept[edge.start];
      edge.end = kept[edge.end];
    }
    panel.vertices = vertices;
  }
}

}  // namespace loosefit::io
