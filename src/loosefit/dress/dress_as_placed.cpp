#include <set>

#include "loosefit/base/error.h"
#include "loosefit/dress/dress.h"
#include "loosefit/geometry/exact_intersection.h"

namespace loosefit {

std::vector<Vec3> dress_as_placed(const Garment& garment, const Pattern& pattern) {
  std::vector<Vec3> sum(garment.vertex_count, Vec3::Zero());
  std::vector<int> count(garment.vertex_count, 0);
  std::set<std::pair<int, int>> seen;  // (vertex, panel)
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const int p = pattern.find_panel(garment.panel_names[garment.triangle_panel[t]]);
    if (p < 0)
      throw GeometryError("pattern: panel " + garment.panel_names[garment.triangle_panel[t]] +
                          " is missing");
    const Panel& panel = pattern.panels[p];
    for (int k = 0; k < 3; ++k) {
      const int v = garment.triangles[t][k];
      if (!seen.emplace(v, p).second) continue;
      const Vec2& uv = garment.triangle_uv[t][k];
      sum[v] += panel.rotation * Vec3(uv[0], uv[1], 0) + panel.translation;
      ++count[v];
    }
  }
  for (int v = 0; v < garment.vertex_count; ++v) sum[v] /= std::max(1, count[v]);
  const auto hits = self_intersections(sum, garment.triangles);
  if (!hits.empty())
    throw GeometryError(
        "pattern: the placed panels cut through each other, " + std::to_string(hits.size()) +
            " triangle pairs, first between " +
            garment.panel_names[garment.triangle_panel[hits[0].first]] + " and " +
            garment.panel_names[garment.triangle_panel[hits[0].second]],
        "move the panels apart (translation, rotation) so that sewn edges face each other");
  return sum;
}

}  // namespace loosefit
