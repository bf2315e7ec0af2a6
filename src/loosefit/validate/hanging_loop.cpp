#include "loosefit/validate/hanging_loop.h"

#include <algorithm>
#include <cmath>

namespace loosefit::validate {
namespace {

/// Direction [rad, from +x towards +z] of the right half of a loop at s in [0, 1] from the clamp to
/// its middle, where it runs in −x. `swell` shapes it without changing its ends.
double direction(LoopKind kind, double s, double swell) {
  const double start = kind == LoopKind::ring ? 0 : kind == LoopKind::pear ? -0.5 * kPi : 0.5 * kPi;
  return start + (-kPi - start) * s + swell * std::sin(kPi * s);
}

/// Right half of a loop of length 2: points at s = i/steps.
std::vector<Vec2> half_loop(LoopKind kind, double swell, int steps) {
  std::vector<Vec2> points{Vec2::Zero()};
  for (int i = 0; i < steps; ++i) {
    const double a = direction(kind, (i + 0.5) / steps, swell);
    points.push_back(points.back() + Vec2(std::cos(a), std::sin(a)) / steps);
  }
  return points;
}

/// The guess that closes: the middle of the loop below its clamp.
std::vector<Vec2> closed_half_loop(LoopKind kind) {
  constexpr int kSteps = 400;
  double low = -1.5, high = 2;  // in between, a larger swell leads farther out
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (half_loop(kind, middle, kSteps).back()[0] < 0 ? low : high) = middle;
  }
  return half_loop(kind, high, kSteps);
}

}  // namespace

HangingLoop::HangingLoop(LoopKind kind, int elements) : kind_(kind), fabric_(beam_fabric()) {
  constexpr double kLength = 0.1;
  const double edge = kLength / elements;
  strip_ = cut_clamped_strip(kLength, 6 * edge, edge, fabric_,
                             kind == LoopKind::ring ? Ends::one_clamp : Ends::clamped, 2);
  gap_ = kind == LoopKind::ring ? 0.5 * clamp_depth(Ends::one_clamp, edge) : 2 * fabric_.thickness;

  const std::vector<Vec2> half = closed_half_loop(kind);
  const double l = strip_.length, a = direction(kind, 0, 0);
  const int steps = static_cast<int>(half.size()) - 1;
  // Position at s in [0, 1] of the right half; straight on behind the clamp.
  const auto right = [&](double s) -> Vec2 {
    if (s <= 0) return s * Vec2(std::cos(a), std::sin(a));
    const double place = std::min(s, 1.0) * steps;
    const int i = std::min(static_cast<int>(place), steps - 1);
    return half[i] + (place - i) * (half[i + 1] - half[i]);
  };
  const auto at = [&](double share) {  // of the whole length
    const double s = share <= 0.5 ? 2 * share : 2 * (1 - share);
    const Vec2 p = 0.5 * l * right(s);
    const double side = share <= 0.5 ? 1 : -1;
    return Vec3(side * (p[0] + gap_), 0, p[1]);
  };
  const Specimen& s = strip_.specimen;
  x_.resize(s.vertex_count);
  for (int v = 0; v < s.vertex_count; ++v)
    x_[v] = at(strip_.share(s.vertex_uv[v])) + Vec3(0, s.vertex_uv[v][1], 0);
  // Held vertices stay straight: what lies in the clamp does not follow the guess.
  const auto straighten = [&](const std::vector<int>& clamp, double side, double end) {
    for (int v : clamp) {
      const double before = side * (s.vertex_uv[v][0] - end);  // behind the clamp where negative
      x_[v] = Vec3(side * (before * std::cos(a) + gap_), s.vertex_uv[v][1], before * std::sin(a));
    }
  };
  straighten(strip_.clamp, 1, 0);
  straighten(strip_.end_clamp, -1, l);
  if (kind == LoopKind::ring)  // one piece, whose far side is the end of the strip
    for (int v : strip_.end) x_[v] = Vec3(-gap_, s.vertex_uv[v][1], 0);
}

void HangingLoop::settle(double gravity_number, Progress& progress) {
  const double l = strip_.length, b = fabric_.bending_weft;
  Bench::Options options;
  options.gravity = gravity_number * b / (l * l * l * fabric_.areal_density);
  Bench bench(
      strip_.specimen, fabric_, [](const Vec2&) { return Vec3::Zero(); }, options);
  bench.x = x_;
  bench.hold(strip_.clamp);
  bench.hold(strip_.end_clamp);
  // At rest against the weight Γ B/L² or, where it is larger, the force 4π² B/L² that bends a strip
  // of this length: under less weight than that, round-off is all that is left of a residual.
  const double bending = 4 * kPi * kPi;
  const double tolerance = gravity_number > 0
                               ? kBenchTolerance * std::max(1.0, bending / gravity_number)
                               : kBenchTolerance * bending * b / (l * l) * strip_.width;
  settle_bench(bench, progress, tolerance);
  x_ = bench.x;
}

double HangingLoop::height() const {
  double lowest = 0;
  for (const Vec3& p : x_) lowest = std::min(lowest, p[2]);
  return -lowest / strip_.length;
}

double HangingLoop::half_width() const {
  double left = 0, right = 0;
  for (const Vec3& p : x_) {
    left = std::min(left, p[0]);
    right = std::max(right, p[0]);
  }
  return (0.5 * (right - left) - gap_) / strip_.length;
}

}  // namespace loosefit::validate
