#include "loosefit/pattern/inset_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/pattern/outline.h"

namespace loosefit::pattern {
namespace {

constexpr int kLooks = 8;  ///< places along a segment at which its distances are measured

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (a + t * along - p).norm();
}

std::vector<Vec2> divided(const MeshInset& inset) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < inset.outline.size(); ++i) {
    const Vec2 &a = inset.outline[i], &b = inset.outline[(i + 1) % inset.outline.size()];
    const int n = std::max(1, static_cast<int>(std::lround((b - a).norm() / inset.spacing)));
    for (int k = 0; k < n; ++k) points.push_back(a + k * (b - a) / n);
  }
  return points;
}

}  // namespace

double MeshSizes::at(const Vec2& p) const {
  double size = edge_length_;
  for (const MeshInset& inset : insets_) {
    const double away =
        inside_polygon(inset.outline, p) ? 0 : (closest_on_polygon(inset.outline, p) - p).norm();
    size = std::min(size, inset.spacing + kGrowth * away);
  }
  return size;
}

double MeshSizes::density(const Vec2& p) const {
  if (insets_.empty()) return 1;
  const double finer = edge_length_ / at(p);
  return finer * finer;
}

double InsetLines::distance(const Vec2& p) const {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : segments)
    least = std::min(least, distance_to_segment(p, points[a], points[b]));
  return least;
}

void InsetLines::add(const MeshInset& inset, double gap,
                     const std::function<double(const Vec2&)>& room) {
  const InsetLines before = *this;
  const std::vector<Vec2> line = divided(inset);
  const auto is_clear = [&](const Vec2& a, const Vec2& b) {
    for (int k = 0; k <= kLooks; ++k) {
      const Vec2 p = a + double(k) / kLooks * (b - a);
      if (std::min(room(p), before.distance(p)) < gap * inset.spacing) return false;
    }
    return true;
  };
  std::vector<int> number(line.size(), -1);
  const auto numbered = [&](std::size_t i) {
    if (number[i] < 0) {
      number[i] = static_cast<int>(points.size());
      points.push_back(line[i]);
    }
    return number[i];
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::size_t next = (i + 1) % line.size();
    if (!is_clear(line[i], line[next])) continue;
    const int a = numbered(i), b = numbered(next);
    segments.push_back({a, b});
  }
}

}  // namespace loosefit::pattern
