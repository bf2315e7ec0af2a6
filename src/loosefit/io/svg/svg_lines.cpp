#include "loosefit/io/svg/svg_lines.h"

#include <algorithm>

#include "loosefit/io/pieces/piece_outline.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::io {
namespace {

constexpr double kTolerance = 2e-5;  // of chords [m]

/// Whether the extent of one lies in that of the other, which is quickly told.
bool may_lie_inside(const std::vector<Vec2>& inner, const std::vector<Vec2>& outer) {
  const Eigen::AlignedBox2d a = box_of(inner), b = box_of(outer);
  return a.min().x() > b.min().x() - kChainGap && a.min().y() > b.min().y() - kChainGap &&
         a.max().x() < b.max().x() + kChainGap && a.max().y() < b.max().y() + kChainGap;
}

}  // namespace

Eigen::AlignedBox2d box_of(const std::vector<Vec2>& points) {
  Eigen::AlignedBox2d box;
  for (const Vec2& p : points) box.extend(p);
  return box;
}

std::vector<Vec2> in_metres(std::vector<Vec2> points, double unit) {
  for (Vec2& p : points) p = Vec2(unit * p.x(), -unit * p.y());
  return points;
}

SampledRun sampled_in_metres(const SvgRun& run, double unit) {
  SampledRun line = sampled(run, kTolerance / unit);
  line.points = in_metres(std::move(line.points), unit);
  line.nodes = in_metres(std::move(line.nodes), unit);
  if (!line.closed && line.points.size() > 3 &&
      (line.points.front() - line.points.back()).norm() < kChainGap) {
    line.points.pop_back();
    line.closed = true;
  }
  return line;
}

bool lies_inside(const std::vector<Vec2>& inner, const std::vector<Vec2>& outer) {
  if (!may_lie_inside(inner, outer)) return false;
  return std::all_of(inner.begin(), inner.end(), [&](const Vec2& p) {
    return pattern::inside_polygon(outer, p) ||
           (pattern::closest_on_polygon(outer, p) - p).norm() < kChainGap;
  });
}

}  // namespace loosefit::io
