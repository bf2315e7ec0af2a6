#include "loosefit/garment/lay_elastics.h"

#include "loosefit/garment/lay_band.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::garment {
namespace {

constexpr int kPieces = 48;  // along an edge
/// The weight of a tape, along the edge: it is part of the garment, not a thing fixed to it.
void add_mass(Garment& g, int panel, int edge, double mass) {
  for (const Garment::EdgeChain& chain : g.edge_chains) {
    if (chain.panel != panel || chain.edge != edge) continue;
    const std::size_t parts = chain.vertices.size() - 1;
    for (std::size_t i = 0; i < parts; ++i)
      for (const int v : {chain.vertices[i], chain.vertices[i + 1]})
        g.vertex_mass[v] += mass / static_cast<double>(2 * parts);
    g.mass += mass;
  }
}

}  // namespace

void lay_elastics(Garment& garment, const pattern::Pattern& pattern) {
  for (int p = 0; p < static_cast<int>(pattern.panels.size()); ++p) {
    const pattern::Panel& panel = pattern.panels[p];
    for (int e = 0; e < static_cast<int>(panel.edges.size()); ++e) {
      const auto& elastic = panel.edges[e].elastic;
      if (!elastic) continue;
      Cable tape;
      tape.path = pattern::edge_points(panel, e, kPieces);
      tape.width = 2 * elastic->width;  // to both sides of the edge, of which one has cloth
      tape.axial_stiffness = elastic->stiffness;
      tape.pre_stretch = 1 / elastic->ratio - 1;
      lay_band(garment, p, tape);
      const double as_cut = elastic->ratio * pattern::edge_lengths(panel)[e];
      add_mass(garment, p, e, elastic->linear_density * as_cut);
    }
  }
}

}  // namespace loosefit::garment
