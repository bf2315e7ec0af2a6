#include "loosefit/garment/open_seams.h"

#include <map>
#include <tuple>

#include "loosefit/geometry/flat_triangle.h"

namespace loosefit::garment {

OpenSeams open_seams(const Garment& sewn) {
  OpenSeams open;
  Garment& g = open.garment;
  g.triangle_uv = sewn.triangle_uv;
  g.triangle_panel = sewn.triangle_panel;
  g.panel_names = sewn.panel_names;
  g.panel_parts = sewn.panel_parts;
  g.triangle_membrane_factor = sewn.triangle_membrane_factor;
  g.bands = sewn.bands;
  g.triangle_added_bending.assign(sewn.triangles.size(), 0.0);
  g.area = sewn.area;
  g.mass = sewn.mass;

  std::map<std::tuple<int, double, double>, int> number;  // panel, u, v
  std::vector<std::vector<int>> copies(sewn.vertex_count);
  const double density = sewn.mass / sewn.area;
  for (std::size_t t = 0; t < sewn.triangles.size(); ++t) {
    Triangle corners;
    const double third = geometry::flat_area(sewn.triangle_uv[t]) * density / 3;
    for (int k = 0; k < 3; ++k) {
      const int panel = sewn.triangle_panel[t];
      const Vec2& uv = sewn.triangle_uv[t][k];
      const auto [at, is_new] = number.try_emplace({panel, uv[0], uv[1]}, g.vertex_count);
      if (is_new) {
        ++g.vertex_count;
        g.vertex_panel.push_back(panel);
        g.vertex_uv.push_back(uv);
        g.vertex_mass.push_back(0);
        open.sewn.push_back(sewn.triangles[t][k]);
        copies[sewn.triangles[t][k]].push_back(at->second);
      }
      corners[k] = at->second;
      g.vertex_mass[at->second] += third;
    }
    g.triangles.push_back(corners);
  }
  for (std::vector<int>& of : copies)
    if (of.size() > 1) open.partners.push_back(std::move(of));
  return open;
}

}  // namespace loosefit::garment
