#include "loosefit/drape/free_fall.h"

#include <algorithm>
#include <limits>
#include <set>

#include "loosefit/base/text.h"
#include "loosefit/base/union_find.h"

namespace loosefit::drape {
namespace {

/// The sets, in the order of their first members.
std::vector<std::vector<int>> members(UnionFind& sets, int count) {
  std::vector<std::vector<int>> all(count);
  for (int i = 0; i < count; ++i) all[sets.find(i)].push_back(i);
  std::erase_if(all, [](const std::vector<int>& s) { return s.empty(); });
  return all;
}

}  // namespace

FreeFall::FreeFall(const std::vector<const garment::Garment*>& layers, const FreeFallTuning& tuning)
    : layers_(layers), tuning_(tuning) {
  int vertices = 0;
  for (const garment::Garment* layer : layers) vertices += layer->vertex_count;
  UnionFind sewn(vertices);
  int first = 0;
  for (const garment::Garment* layer : layers) {
    for (const Triangle& t : layer->triangles)
      for (int k : {1, 2}) sewn.unite(first + t[0], first + t[k]);
    first += layer->vertex_count;
  }
  pieces_ = members(sewn, vertices);
}

bool FreeFall::misses(const std::vector<Vec3>& x, const std::vector<int>& cloth,
                      const geometry::Box3& body) const {
  Vec3 centre = Vec3::Zero();
  double top = -std::numeric_limits<double>::infinity(), reach = 0;
  for (int v : cloth) centre += x[v], top = std::max(top, x[v].z());
  centre /= static_cast<double>(cloth.size());
  if (top < body.min().z()) return true;
  for (int v : cloth) reach = std::max(reach, (x[v] - centre).norm());
  const Vec2 at = centre.head<2>();
  const Vec2 nearest = at.cwiseMax(body.min().head<2>()).cwiseMin(body.max().head<2>());
  return (at - nearest).norm() > reach + tuning_.aside;
}

std::optional<Stop> FreeFall::falling(const std::vector<Vec3>& x,
                                      const geometry::Box3& body) const {
  std::vector<geometry::Box3> boxes;
  for (const std::vector<int>& piece : pieces_) {
    geometry::Box3 box;
    for (int v : piece) box.extend(x[v]);
    const Vec3 margin = Vec3::Constant(tuning_.together / 2);
    boxes.emplace_back(Vec3(box.min() - margin), Vec3(box.max() + margin));
  }
  UnionFind near(pieces_.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
      if (boxes[i].intersects(boxes[j])) near.unite(static_cast<int>(i), static_cast<int>(j));
  std::vector<int> lost;
  for (const std::vector<int>& group : members(near, static_cast<int>(pieces_.size()))) {
    std::vector<int> cloth;
    for (int piece : group) cloth.insert(cloth.end(), pieces_[piece].begin(), pieces_[piece].end());
    if (misses(x, cloth, body)) lost.insert(lost.end(), group.begin(), group.end());
  }
  if (lost.empty()) return {};
  if (lost.size() == pieces_.size()) return Stop{StopReason::cloth_falls};
  return Stop{.reason = StopReason::pieces_fall,
              .pieces = static_cast<int>(lost.size()),
              .panels = panels_of(lost)};
}

std::vector<std::string> FreeFall::panels_of(const std::vector<int>& pieces) const {
  std::vector<std::string> names;
  for (int piece : pieces) {
    const std::set<int> vertices(pieces_[piece].begin(), pieces_[piece].end());
    int first = 0;
    for (std::size_t l = 0; l < layers_.size(); first += layers_[l++]->vertex_count) {
      const garment::Garment& garment = *layers_[l];
      std::set<int> panels;
      for (std::size_t t = 0; t < garment.triangles.size(); ++t)
        if (vertices.count(first + garment.triangles[t][0]))
          panels.insert(garment.triangle_panel[t]);
      for (int panel : panels) names.push_back(printable(garment.panel_names[panel]));
    }
  }
  return names;
}

}  // namespace loosefit::drape
