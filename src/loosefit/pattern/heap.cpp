#include "loosefit/pattern/heap.h"

#include <algorithm>
#include <cmath>

#include "loosefit/pattern/outline.h"

namespace loosefit::pattern {
namespace {

constexpr double kOnePlane = 0.005;  ///< between planes that count as the same [m]
constexpr double kParallel = 0.99;   ///< cosine
constexpr double kCovered = 0.5;     ///< of a box

/// The box of a panel in the axes of `plane`.
Eigen::AlignedBox2d box_in(const Panel& plane, const Panel& panel) {
  Eigen::AlignedBox2d box;
  for (const Vec2& p : outline_polygon(panel, 4)) {
    const Vec3 at =
        plane.rotation.transpose() * (panel.rotation * Vec3(p.x(), p.y(), 0) + panel.translation);
    box.extend(Vec2(at.x(), at.y()));
  }
  return box;
}

bool in_one_plane(const Panel& panel, const Panel& other) {
  const Vec3 n = panel.rotation.col(2);
  return std::abs(n.dot(other.rotation.col(2))) > kParallel &&
         std::abs(n.dot(other.translation - panel.translation)) < kOnePlane;
}

bool lies_on(const Panel& panel, const Panel& other) {
  if (!in_one_plane(panel, other)) return false;
  const Eigen::AlignedBox2d box = box_in(panel, panel);
  const Eigen::AlignedBox2d common = box.intersection(box_in(panel, other));
  return !common.isEmpty() && common.volume() > kCovered * box.volume();
}

}  // namespace

bool lies_in_a_heap(const Pattern& pattern) {
  const auto& panels = pattern.panels;
  if (panels.size() < 2) return false;
  if (std::ranges::all_of(panels, [](const Panel& p) { return p.translation.norm() < kOnePlane; }))
    return true;
  return std::ranges::any_of(panels, [&](const Panel& plane) {
    const auto on_another = std::ranges::count_if(panels, [&](const Panel& panel) {
      return in_one_plane(plane, panel) && std::ranges::any_of(panels, [&](const Panel& other) {
               return &other != &panel && lies_on(panel, other);
             });
    });
    return 2 * static_cast<std::size_t>(on_another) > panels.size();
  });
}

}  // namespace loosefit::pattern
