#include "loosefit/pattern/cap_scoop.h"

#include <algorithm>
#include <cstddef>

#include "loosefit/geometry/flat_triangle.h"

namespace loosefit::pattern {

double cap_scoop(const Panel& panel, const Section& cap) {
  const std::vector<Vec2> points = section_points(panel, cap);
  const Vec2 along = (cap.to - cap.from).normalized();
  std::size_t top = 0;
  double highest = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const double h = -geometry::cross(along, points[i] - cap.from); h > highest)
      highest = h, top = i;
  if (top == 0 || top + 1 >= points.size()) return 0;
  const auto fill = [&](std::size_t a, std::size_t b) {
    // Area under the half, against its box.
    double area = 0;
    for (std::size_t i = a; i < b; ++i)
      area -= (geometry::cross(along, points[i] - cap.from) +
               geometry::cross(along, points[i + 1] - cap.from)) /
              2 * (points[i + 1] - points[i]).dot(along);
    const double wide = (points[b] - points[a]).dot(along);
    return area / std::max(1e-9, wide * highest);
  };
  return fill(top, points.size() - 1) - fill(0, top);
}

}  // namespace loosefit::pattern
