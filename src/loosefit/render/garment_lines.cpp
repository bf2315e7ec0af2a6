#include "loosefit/render/garment_lines.h"

#include "loosefit/geometry/mesh_topology.h"

namespace loosefit::render {

GarmentLines garment_lines(const garment::Garment& garment) {
  struct Side {
    int panel = 0;
    Vec2 low, high;  ///< pattern position at the lower and the higher vertex
  };
  const auto side = [&](const geometry::MeshTopology::Side& at) -> Side {
    const int t = at.triangle, k = at.corner, next = (k + 1) % 3;
    const Vec2 &ua = garment.triangle_uv[t][k], &ub = garment.triangle_uv[t][next];
    const bool up = garment.triangles[t][k] < garment.triangles[t][next];
    return {garment.triangle_panel[t], up ? ua : ub, up ? ub : ua};
  };
  const geometry::MeshTopology topology(garment.triangles);
  constexpr double kSamePlace = 1e-9;  // [m]
  GarmentLines lines;
  for (int e = 0; e < topology.edge_count(); ++e) {
    const auto& edge = topology.edges()[e];
    const auto sides = topology.sides(e);
    if (sides.size() == 1) {
      lines.boundary.push_back(edge);
      continue;
    }
    const Side s = side(sides[0]), t = side(sides[1]);
    if (s.panel != t.panel || (s.low - t.low).norm() > kSamePlace ||
        (s.high - t.high).norm() > kSamePlace)
      lines.seams.push_back(edge);
  }
  return lines;
}

}  // namespace loosefit::render
