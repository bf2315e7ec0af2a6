#include "loosefit/kinds/shirt/sleeve_width.h"

#include <algorithm>

#include "loosefit/pattern/outline.h"

namespace loosefit::kinds {

double width_below_cap(const pattern::Panel& half, double down) {
  constexpr double kNear = 1e-5;  // for the direction of the seam [m]
  const int e = pattern::find_edge_part(half, "top");
  if (e < 0) return 0;
  const pattern::EdgePath top(half, e);
  const bool downwards = top.at(0).y() > top.at(1).y();
  const auto at = [&](double from_cap) {
    const double share = from_cap / top.length();
    return top.at(downwards ? share : 1 - share);
  };
  const Vec2 foot = at(down), along = (foot - at(down - kNear)).normalized();
  // The far end of the width: where the outline crosses the line, but at the foot itself.
  double width = 0;
  const std::vector<Vec2> outline = pattern::outline_polygon(half);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i] - foot, b = outline[(i + 1) % outline.size()] - foot;
    const double off_a = along.dot(a), off_b = along.dot(b);
    if ((off_a < 0) == (off_b < 0)) continue;
    const Vec2 p = a - off_a / (off_b - off_a) * (b - a);
    width = std::max(width, p.norm());
  }
  return width;
}

}  // namespace loosefit::kinds
