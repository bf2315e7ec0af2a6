#include "loosefit/garment/thicken.h"

#include <cmath>

#include "loosefit/garment/covered_share.h"
#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::garment {
namespace {

constexpr int kHemPieces = 48;  // along an edge

/// Mass, stiffness and rigidity of a triangle, times those of plain cloth, on top of what it has.
void add(Garment& g, std::size_t t, const pattern::PanelCloth& cloth,
         const fabric::Material& material) {
  const double more =
      (cloth.mass - 1) * geometry::flat_area(g.triangle_uv[t]) * material.areal_density;
  for (const int corner : g.triangles[t]) g.vertex_mass[corner] += more / 3;
  g.mass += more;
  g.triangle_membrane_factor[t] *= cloth.membrane;
  g.triangle_added_bending[t] +=
      (cloth.bending - 1) * std::sqrt(material.bending_warp * material.bending_weft);
}

}  // namespace

void thicken(Garment& g, const pattern::Pattern& pattern, const fabric::Material& material) {
  for (int p = 0; p < static_cast<int>(pattern.panels.size()); ++p) {
    const pattern::Panel& panel = pattern.panels[p];
    std::vector<std::vector<Vec2>> edges;
    std::vector<PathStrip> hems;
    edges.reserve(panel.edges.size());  // the strips refer to them
    for (int e = 0; e < static_cast<int>(panel.edges.size()); ++e)
      if (const double width = panel.edges[e].finish; width > 0) {
        edges.push_back(pattern::edge_points(panel, e, kHemPieces));
        hems.emplace_back(edges.back(), 2 * width);  // to both sides of the edge
      }
    if (hems.empty() && panel.cloth == pattern::PanelCloth{}) continue;
    for (std::size_t t = 0; t < g.triangles.size(); ++t) {
      if (g.triangle_panel[t] != p) continue;
      add(g, t, panel.cloth, material);
      const auto& [a, b, c] = g.triangle_uv[t];
      for (PathStrip& hem : hems) {
        if (!hem.may_cover(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c))) continue;
        const double share = covered_share(g.triangle_uv[t], hem);
        add(g, t, {1 + share, 1 + share, 1 + share * (kHemBending - 1)}, material);
      }
    }
  }
}

}  // namespace loosefit::garment
