#include "loosefit/placement/tolerance.h"

#include <algorithm>

#include "loosefit/base/error.h"

namespace loosefit::placement {
namespace {

constexpr double kResolution = 1e-6;  // [m]

struct Shift {
  double length = 0;
  Tolerance::End end = Tolerance::End::reach;
};

/// Largest shift from `at` along the unit vector `way` with a score of at least `least`.
Shift shift_along(const FlatScore& score, const Vec2& at, const Vec2& way, double least,
                  const ToleranceOptions& options) {
  const auto at_shift = [&](double s) { return score(at + s * way); };
  double good = 0;
  while (good < options.reach) {
    double bad = std::min(good + options.step, options.reach);
    if (const auto q = at_shift(bad); q && *q >= least) {
      good = bad;
      continue;
    }
    bool inside = at_shift(bad).has_value();
    while (bad - good > kResolution) {
      const double middle = 0.5 * (good + bad);
      const auto q = at_shift(middle);
      if (q && *q >= least) {
        good = middle;
      } else {
        bad = middle;
        inside = q.has_value();
      }
    }
    return {good, inside ? Tolerance::End::score : Tolerance::End::outline};
  }
  return {options.reach, Tolerance::End::reach};
}

}  // namespace

Tolerance tolerance(const FlatScore& score, const Vec2& at, const Vec2& direction,
                    const ToleranceOptions& options) {
  if (!(direction.norm() > 0))
    throw InvalidInput("tolerance: found a direction of length 0, expected one along the segment");
  if (!(options.step > kResolution && options.reach > 0 && options.loss >= 0 && options.loss < 1))
    throw InvalidInput(
        "tolerance: found step, reach or loss out of range, expected positive lengths and a share "
        "below 1");
  Tolerance result;
  result.direction = direction.normalized();
  const auto here = score(at);
  if (!here || *here <= 0) {
    result.along_end = result.around_end = here ? Tolerance::End::score : Tolerance::End::outline;
    return result;
  }
  const double least = (1 - options.loss) * *here;
  const auto both_ways = [&](const Vec2& way) {
    const Shift a = shift_along(score, at, way, least, options);
    const Shift b = shift_along(score, at, -way, least, options);
    return b.length < a.length ? b : a;
  };
  const Shift along = both_ways(result.direction);
  const Shift around = both_ways(Vec2(-result.direction.y(), result.direction.x()));
  result.along = along.length;
  result.along_end = along.end;
  result.around = around.length;
  result.around_end = around.end;
  return result;
}

}  // namespace loosefit::placement
