#include "loosefit/maps/fine_cloth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "loosefit/base/error.h"
#include "loosefit/geometry/flat_triangle.h"

namespace loosefit::maps {
namespace {

/// Edge of the equilateral triangle of the mean flat area [m].
double mean_edge(const garment::Garment& g) {
  double area = 0;
  for (const auto& uv : g.triangle_uv) area += geometry::flat_area(uv);
  return std::sqrt(4 / std::sqrt(3.0) * area / static_cast<double>(g.triangles.size()));
}

void halve_edges(garment::Garment& g, std::vector<Vec3>& positions) {
  std::map<std::pair<int, int>, int> middles;
  std::vector<Triangle> triangles;
  std::vector<std::array<Vec2, 3>> triangle_uv;
  std::vector<int> triangle_panel;
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    const Triangle c = g.triangles[t];
    const std::array<Vec2, 3> uv = g.triangle_uv[t];
    Triangle m;
    std::array<Vec2, 3> muv;
    for (int k = 0; k < 3; ++k) {
      const int a = c[k], b = c[(k + 1) % 3];
      muv[k] = 0.5 * (uv[k] + uv[(k + 1) % 3]);
      const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), g.vertex_count);
      m[k] = at->second;
      if (is_new) {
        ++g.vertex_count;
        positions.push_back(0.5 * (positions[a] + positions[b]));
        g.vertex_panel.push_back(g.triangle_panel[t]);
        g.vertex_uv.push_back(muv[k]);
      } else if (g.triangle_panel[t] < g.vertex_panel[m[k]]) {
        g.vertex_panel[m[k]] = g.triangle_panel[t], g.vertex_uv[m[k]] = muv[k];
      }
    }
    for (int k = 0; k < 3; ++k) {
      triangles.push_back({c[k], m[k], m[(k + 2) % 3]});
      triangle_uv.push_back({uv[k], muv[k], muv[(k + 2) % 3]});
    }
    triangles.push_back(m);
    triangle_uv.push_back(muv);
    triangle_panel.insert(triangle_panel.end(), 4, g.triangle_panel[t]);
  }
  g.triangles = std::move(triangles), g.triangle_uv = std::move(triangle_uv);
  g.triangle_panel = std::move(triangle_panel);
}

}  // namespace

FineCloth cut_finer(const garment::Garment& garment, const std::vector<Vec3>& positions,
                    const body::PosedBody& body, double edge) {
  if (!(edge > 0)) throw InvalidInput("a cloth is cut into triangles with edges of more than 0 m");
  FineCloth fine;
  garment::Garment& g = fine.garment;
  g.vertex_count = garment.vertex_count, g.area = garment.area;
  g.triangles = garment.triangles, g.triangle_uv = garment.triangle_uv;
  g.triangle_panel = garment.triangle_panel;
  g.panel_names = garment.panel_names, g.panel_parts = garment.panel_parts;
  g.vertex_panel = garment.vertex_panel, g.vertex_uv = garment.vertex_uv;
  fine.positions = positions;
  while (!g.triangles.empty() && mean_edge(g) > edge) halve_edges(g, fine.positions);
  fine.worn = relate(g, fine.positions, body);
  return fine;
}

}  // namespace loosefit::maps
