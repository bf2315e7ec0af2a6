#include "loosefit/render/garment_lines.h"

#include <algorithm>
#include <map>

namespace loosefit::render {

GarmentLines garment_lines(const garment::Garment& garment) {
  struct Side {
    int panel = 0;
    Vec2 low, high;  ///< pattern position at the lower and the higher vertex
  };
  std::map<std::array<int, 2>, std::vector<Side>> edges;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = garment.triangles[t][k], b = garment.triangles[t][(k + 1) % 3];
      const Vec2 &ua = garment.triangle_uv[t][k], &ub = garment.triangle_uv[t][(k + 1) % 3];
      edges[{std::min(a, b), std::max(a, b)}].push_back(
          {garment.triangle_panel[t], a < b ? ua : ub, a < b ? ub : ua});
    }
  constexpr double kSamePlace = 1e-9;  // [m]
  GarmentLines lines;
  for (const auto& [edge, sides] : edges) {
    if (sides.size() == 1) {
      lines.boundary.push_back(edge);
      continue;
    }
    const Side &s = sides[0], &t = sides[1];
    if (s.panel != t.panel || (s.low - t.low).norm() > kSamePlace ||
        (s.high - t.high).norm() > kSamePlace)
      lines.seams.push_back(edge);
  }
  return lines;
}

}  // namespace loosefit::render
