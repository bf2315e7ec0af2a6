#include "loosefit/io/svg/svg_lines.h"

#include "loosefit/io/pieces/piece_outline.h"

namespace loosefit::io {
namespace {

constexpr double kTolerance = 2e-5;  // of chords [m]

}  // namespace

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

}  // namespace loosefit::io
