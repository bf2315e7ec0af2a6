#include "loosefit/flesh/skin_patch.h"

#include <array>
#include <cmath>
#include <set>

namespace loosefit::flesh {

std::vector<Vec3> SkinPatch::of(const std::vector<Vec3>& surface) const {
  std::vector<Vec3> x;
  x.reserve(vertex.size());
  for (int v : vertex) x.push_back(surface[v]);
  return x;
}

SkinPatch patch_round(const geometry::TriangleMesh& skin,
                      const std::vector<std::pair<int, int>>& overlaps, double margin) {
  using Cell = std::array<int, 3>;
  const auto cell_of = [&](const Vec3& p) {
    const auto at = [&](double v) { return static_cast<int>(std::floor(v / margin)); };
    return Cell{at(p[0]), at(p[1]), at(p[2])};
  };
  std::set<Cell> near;
  for (const auto& [s, t] : overlaps)
    for (int triangle : {s, t})
      for (int v : skin.triangles[triangle]) {
        const Cell c = cell_of(skin.vertices[v]);
        for (int x = -1; x <= 1; ++x)
          for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) near.insert({c[0] + x, c[1] + y, c[2] + z});
      }
  std::vector<char> inside(skin.vertices.size()), used(inside.size()), cut_off(inside.size());
  for (std::size_t v = 0; v < inside.size(); ++v) inside[v] = near.count(cell_of(skin.vertices[v]));
  const auto whole = [&](const Triangle& t) {
    return inside[t[0]] && inside[t[1]] && inside[t[2]];
  };
  for (const Triangle& t : skin.triangles)
    for (int v : t) (whole(t) ? used : cut_off)[v] = true;

  SkinPatch patch;
  std::vector<int> number(inside.size(), -1);
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    number[v] = static_cast<int>(patch.vertex.size());
    patch.vertex.push_back(static_cast<int>(v));
    patch.on_rim.push_back(cut_off[v]);
  }
  for (const Triangle& t : skin.triangles)
    if (whole(t)) patch.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  return patch;
}

}  // namespace loosefit::flesh
