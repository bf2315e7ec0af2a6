#include "loosefit/drape/hood_seam.h"

#include <algorithm>
#include <map>
#include <set>

#include "loosefit/geometry/mesh_topology.h"

namespace loosefit::drape {

std::vector<int> hood_seam(const garment::Garment& garment, const std::vector<Opening>& openings,
                           const Opening& opening) {
  const geometry::MeshTopology topology(garment.triangles);
  // Panels whose triangles have an edge on a rim.
  const auto panels_at = [&](const Opening& o) {
    std::set<int> found;
    for (std::size_t i = 0; i < o.loop.size(); ++i) {
      const int e = topology.find(o.loop[i], o.loop[(i + 1) % o.loop.size()]);
      if (e >= 0) found.insert(garment.triangle_panel[topology.sides(e)[0].triangle]);
    }
    return found;
  };
  std::set<int> hood = panels_at(opening);
  for (const Opening& o : openings)
    if (&o != &opening)
      for (int panel : panels_at(o)) hood.erase(panel);
  if (hood.empty()) return {};
  // Edges between them and the others, as one chain.
  std::map<int, std::vector<int>> next;
  for (int e = 0; e < topology.edge_count(); ++e) {
    const auto sides = topology.sides(e);
    if (sides.size() < 2) continue;
    const bool first = hood.count(garment.triangle_panel[sides[0].triangle]) > 0,
               second = hood.count(garment.triangle_panel[sides[1].triangle]) > 0;
    if (first == second) continue;
    const auto [a, b] = topology.edges()[e];
    next[a].push_back(b);
    next[b].push_back(a);
  }
  if (next.empty()) return {};
  int start = next.begin()->first;
  for (const auto& [v, to] : next) {
    if (to.size() > 2) return {};
    if (to.size() == 1) start = v;
  }
  std::vector<int> chain = {start};
  for (int last = -1, at = start;;) {
    const std::vector<int>& to = next[at];
    const int step = to[0] != last || to.size() == 1 ? to[0] : to[1];
    if (step == last || step == start) break;
    chain.push_back(step);
    last = at, at = step;
  }
  return chain.size() == next.size() ? chain : std::vector<int>{};
}

}  // namespace loosefit::drape
