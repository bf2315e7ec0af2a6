#include "loosefit/pipeline/edge_distances.h"

#include <algorithm>
#include <cmath>

#include "loosefit/pattern/outline.h"

namespace loosefit::pipeline {
namespace {

constexpr int kEdgePieces = 200;

Vec2 closest(const std::vector<Vec2>& points, const Vec2& at) {
  Vec2 best = points[0];
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 side = points[i + 1] - points[i];
    const double length = side.squaredNorm();
    const double t = length > 0 ? std::clamp((at - points[i]).dot(side) / length, 0.0, 1.0) : 0;
    const Vec2 p = points[i] + t * side;
    if ((p - at).norm() < (best - at).norm()) best = p;
  }
  return best;
}

}  // namespace

std::vector<EdgeDistance> edge_distances(const pattern::Panel& panel, const Vec2& at) {
  std::vector<EdgeDistance> all;
  for (int e = 0; e < static_cast<int>(panel.edges.size()); ++e) {
    const Vec2 foot = closest(pattern::edge_points(panel, e, kEdgePieces), at);
    all.push_back({e, foot, (foot - at).norm()});
  }
  std::stable_sort(all.begin(), all.end(), [](const EdgeDistance& a, const EdgeDistance& b) {
    return a.length < b.length;
  });
  if (all.empty()) return all;
  const Vec2 first = all[0].foot - at;
  const auto second = std::find_if(all.begin() + 1, all.end(), [&](const EdgeDistance& other) {
    const Vec2 direction = other.foot - at;
    return std::abs(first.dot(direction)) <= std::sqrt(0.5) * first.norm() * direction.norm();
  });
  if (second == all.end()) return {all[0]};
  return {all[0], *second};
}

}  // namespace loosefit::pipeline
