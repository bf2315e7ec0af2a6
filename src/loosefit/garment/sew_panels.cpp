#include "loosefit/garment/sew_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "loosefit/base/error.h"
#include "loosefit/base/union_find.h"
#include "loosefit/garment/lay_elastics.h"
#include "loosefit/garment/surface_check.h"
#include "loosefit/garment/thicken.h"
#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::garment {
namespace {

std::string seam_key(const pattern::Stitch& stitch, std::size_t index) {
  return "stitch " + (stitch.name.empty() ? std::to_string(index) : stitch.name);
}

double flat_area(const pattern::PanelMesh& mesh) {
  double area = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec2 a = mesh.vertices[t[1]] - mesh.vertices[t[0]],
               b = mesh.vertices[t[2]] - mesh.vertices[t[0]];
    area += 0.5 * std::abs(a.x() * b.y() - a.y() * b.x());
  }
  return area;
}

/// +1 for panels as drawn, −1 for panels turned over because a right_wrong seam joins them. Of each
/// part that hangs together the larger area is as drawn: a lapel is turned over, not the coat.
std::vector<int> panel_signs(const pattern::Pattern& pattern,
                             const std::vector<pattern::PanelMesh>& meshes) {
  std::vector<int> sign(pattern.panels.size(), 0);
  for (std::size_t seed = 0; seed < sign.size(); ++seed) {
    if (sign[seed] != 0) continue;
    sign[seed] = 1;
    std::vector<std::size_t> part = {seed};
    for (bool grown = true; grown;) {
      grown = false;
      for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
        const pattern::Stitch& stitch = pattern.stitches[s];
        const auto first = static_cast<std::size_t>(stitch.first.panel),
                   second = static_cast<std::size_t>(stitch.second.panel);
        int &a = sign[first], &b = sign[second];
        const int turn = stitch.right_wrong ? -1 : 1;
        if (a != 0 && b == 0) b = turn * a, grown = true, part.push_back(second);
        if (b != 0 && a == 0) a = turn * b, grown = true, part.push_back(first);
        if (a != 0 && b != 0 && a != turn * b)
          throw GeometryError(InputPlace{{}, 0, seam_key(stitch, s)},
                              "a seam that makes the cloth one-sided (Möbius strip)",
                              "an outside that continues across every seam",
                              "reverse one side, or use right_wrong on both ends of the band");
      }
    }
    double as_drawn = 0;
    for (const std::size_t panel : part) as_drawn += sign[panel] * flat_area(meshes[panel]);
    if (as_drawn < 0)
      for (const std::size_t panel : part) sign[panel] = -sign[panel];
  }
  return sign;
}

void check_gathers(const pattern::Pattern& pattern) {
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    const pattern::Stitch& stitch = pattern.stitches[s];
    const double a =
        pattern::EdgePath(pattern.panels[stitch.first.panel], stitch.first.edge).length();
    const double b =
        pattern::EdgePath(pattern.panels[stitch.second.panel], stitch.second.edge).length();
    if (std::max(a, b) > kGatherLimit * std::min(a, b))
      throw GeometryError(InputPlace{{}, 0, seam_key(stitch, s)},
                          fmt::format("sides of {:.4f} m and {:.4f} m", a, b),
                          fmt::format("a gather of at most {:g} to 1", kGatherLimit),
                          "the seam cannot close");
  }
}

}  // namespace

SewnPanels sew_panels(const pattern::Pattern& pattern,
                      const std::vector<pattern::PanelMesh>& meshes,
                      const fabric::Material& material,
                      const std::vector<std::vector<int>>* coarser) {
  check_gathers(pattern);
  // Panel vertices numbered through.
  const int panels = static_cast<int>(meshes.size());
  std::vector<int> first(panels + 1, 0);
  for (int p = 0; p < panels; ++p)
    first[p + 1] = first[p] + static_cast<int>(meshes[p].vertices.size());

  UnionFind welds(first[panels]);  // panel vertices that are one in the garment
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    const pattern::Stitch& stitch = pattern.stitches[s];
    const auto& a = meshes[stitch.first.panel].edge_vertices[stitch.first.edge];
    const auto& b = meshes[stitch.second.panel].edge_vertices[stitch.second.edge];
    if (a.size() != b.size())
      throw GeometryError(InputPlace{{}, 0, seam_key(stitch, s)},
                          fmt::format("{} and {} vertices", a.size(), b.size()),
                          "equal counts on both sides");
    for (std::size_t i = 0; i < a.size(); ++i)
      welds.unite(first[stitch.first.panel] + a[i],
                  first[stitch.second.panel] + b[stitch.right_wrong ? i : b.size() - 1 - i]);
  }

  // Numbers of the garment: those of the coarser level stay, new ones follow in panel order.
  SewnPanels sewn;
  Garment& g = sewn.garment;
  std::vector<int> number(first[panels], -1);
  if (coarser) {
    for (int p = 0; p < panels; ++p)
      for (std::size_t i = 0; i < (*coarser)[p].size(); ++i) {
        number[welds.find(first[p] + static_cast<int>(i))] = (*coarser)[p][i];
        g.vertex_count = std::max(g.vertex_count, (*coarser)[p][i] + 1);
      }
  }
  sewn.vertex_of.resize(panels);
  for (int p = 0; p < panels; ++p)
    for (int i = first[p]; i < first[p + 1]; ++i) {
      int& n = number[welds.find(i)];
      if (n < 0) n = g.vertex_count++;
      sewn.vertex_of[p].push_back(n);
    }

  // Pattern coordinates, triangles and masses; a seam vertex belongs to its first panel.
  g.vertex_panel.assign(g.vertex_count, -1);
  g.vertex_uv.assign(g.vertex_count, Vec2::Zero());
  g.vertex_mass.assign(g.vertex_count, 0);
  const std::vector<int> sign = panel_signs(pattern, meshes);
  for (int p = 0; p < panels; ++p) {
    g.panel_names.push_back(pattern.panels[p].name);
    g.panel_parts.push_back(pattern.panels[p].part);
    for (std::size_t i = 0; i < meshes[p].vertices.size(); ++i) {
      const int v = sewn.vertex_of[p][i];
      if (g.vertex_panel[v] >= 0) continue;
      g.vertex_panel[v] = p;
      g.vertex_uv[v] = meshes[p].vertices[i];
    }
    // A panel behind a right_wrong seam shows its inside: its triangles are turned over.
    for (Triangle t : meshes[p].triangles) {
      if (sign[p] < 0) std::swap(t[1], t[2]);
      std::array<Vec2, 3> uv;
      Triangle corners;
      for (int i = 0; i < 3; ++i) {
        uv[i] = meshes[p].vertices[t[i]];
        corners[i] = sewn.vertex_of[p][t[i]];
      }
      const double area = geometry::flat_area(uv);
      g.area += area;
      for (const int c : corners) g.vertex_mass[c] += area * material.areal_density / 3;
      g.triangles.push_back(corners);
      g.triangle_uv.push_back(uv);
      g.triangle_panel.push_back(p);
    }
    // Pattern edges as chains of garment vertices.
    for (std::size_t e = 0; e < meshes[p].edge_vertices.size(); ++e) {
      const pattern::PanelEdge& edge = pattern.panels[p].edges[e];
      Garment::EdgeChain chain{p, static_cast<int>(e), edge.name, edge.part, {}};
      for (const int i : meshes[p].edge_vertices[e]) chain.vertices.push_back(sewn.vertex_of[p][i]);
      g.edge_chains.push_back(chain);
    }
  }
  // Attachments come later.
  g.triangle_membrane_factor.assign(g.triangles.size(), 1.0);
  g.triangle_added_bending.assign(g.triangles.size(), 0.0);
  g.mass = g.area * material.areal_density;
  thicken(g, pattern, material);
  lay_elastics(g, pattern);
  check_surface(g);
  return sewn;
}

}  // namespace loosefit::garment
