#include "loosefit/drape/free_fall.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

#include "loosefit/base/text.h"

namespace loosefit {
namespace {

/// Sets of numbers that are joined pair by pair.
class Sets {
 public:
  explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int of(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int a, int b) {
    const int p = of(a), q = of(b);
    parent_[std::max(p, q)] = std::min(p, q);
  }
  /// In the order of their first members.
  std::vector<std::vector<int>> all() {
    std::vector<std::vector<int>> sets(parent_.size());
    for (int i = 0; i < static_cast<int>(parent_.size()); ++i) sets[of(i)].push_back(i);
    std::erase_if(sets, [](const std::vector<int>& s) { return s.empty(); });
    return sets;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace

FreeFall::FreeFall(const std::vector<const Garment*>& layers, const FreeFallTuning& tuning)
    : layers_(layers), tuning_(tuning) {
  int vertices = 0;
  for (const Garment* layer : layers) vertices += layer->vertex_count;
  Sets sewn(vertices);
  int first = 0;
  for (const Garment* layer : layers) {
    for (const Triangle& t : layer->triangles)
      for (int k : {1, 2}) sewn.join(first + t[0], first + t[k]);
    first += layer->vertex_count;
  }
  pieces_ = sewn.all();
}

bool FreeFall::misses(const std::vector<Vec3>& x, const std::vector<int>& cloth,
                      const Box3& body) const {
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

std::optional<Stop> FreeFall::falling(const std::vector<Vec3>& x, const Box3& body) const {
  std::vector<Box3> boxes;
  for (const std::vector<int>& piece : pieces_) {
    Box3 box;
    for (int v : piece) box.extend(x[v]);
    const Vec3 margin = Vec3::Constant(tuning_.together / 2);
    boxes.emplace_back(Vec3(box.min() - margin), Vec3(box.max() + margin));
  }
  Sets near(pieces_.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
      if (boxes[i].intersects(boxes[j])) near.join(static_cast<int>(i), static_cast<int>(j));
  std::vector<int> lost;
  for (const std::vector<int>& group : near.all()) {
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
      const Garment& garment = *layers_[l];
      std::set<int> panels;
      for (std::size_t t = 0; t < garment.triangles.size(); ++t)
        if (vertices.count(first + garment.triangles[t][0]))
          panels.insert(garment.triangle_panel[t]);
      for (int panel : panels) names.push_back(printable(garment.panel_names[panel]));
    }
  }
  return names;
}

}  // namespace loosefit
