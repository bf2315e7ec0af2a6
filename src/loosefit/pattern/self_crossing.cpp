#include "loosefit/pattern/self_crossing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "loosefit/geometry/flat_triangle.h"
namespace loosefit::pattern {
namespace {

double turn(const Vec2& a, const Vec2& b, const Vec2& c) { return geometry::cross(b - a, c - a); }

bool within_box(const Vec2& a, const Vec2& b, const Vec2& p) {
  return std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) &&
         std::min(a.y(), b.y()) <= p.y() && p.y() <= std::max(a.y(), b.y());
}

bool sides_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double c_side = turn(a, b, c), d_side = turn(a, b, d);
  const double a_side = turn(c, d, a), b_side = turn(c, d, b);
  if (((c_side > 0 && d_side < 0) || (c_side < 0 && d_side > 0)) &&
      ((a_side > 0 && b_side < 0) || (a_side < 0 && b_side > 0)))
    return true;
  return (c_side == 0 && within_box(a, b, c)) || (d_side == 0 && within_box(a, b, d)) ||
         (a_side == 0 && within_box(c, d, a)) || (b_side == 0 && within_box(c, d, b));
}

}  // namespace

std::pair<int, int> first_self_crossing(const std::vector<Vec2>& polygon) {
  const int n = static_cast<int>(polygon.size());
  const auto next = [n](int i) { return (i + 1) % n; };
  for (int i = 0; i < n; ++i) {
    // Neighbouring sides always share a corner; they are wrong only when they fold back.
    const Vec2 &a = polygon[i], &b = polygon[next(i)], &c = polygon[next(next(i))];
    if (a == b || (turn(a, b, c) == 0 && (b - a).dot(c - b) < 0)) return {i, next(i)};
  }
  // Sweep by the lower x of each side, so that only sides overlapping in x are compared.
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  const auto low = [&](int i) { return std::min(polygon[i].x(), polygon[next(i)].x()); };
  const auto high = [&](int i) { return std::max(polygon[i].x(), polygon[next(i)].x()); };
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return low(i) < low(j); });
  for (int k = 0; k < n; ++k)
    for (int m = k + 1; m < n && low(order[m]) <= high(order[k]); ++m) {
      const int i = order[k], j = order[m];
      if (next(i) == j || next(j) == i) continue;
      if (sides_meet(polygon[i], polygon[next(i)], polygon[j], polygon[next(j)]))
        return {std::min(i, j), std::max(i, j)};
    }
  return {-1, -1};
}

bool polygons_meet(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (sides_meet(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()])) return true;
  return false;
}

}  // namespace loosefit::pattern
