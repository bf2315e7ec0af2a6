#pragma once
#include <functional>
#include <optional>

#include "loosefit/base/types.h"

namespace loosefit::placement {

/// Score of a place of one panel by its flat coordinates [m]; nothing outside the panel, and where
/// no sensor may be.
using FlatScore = std::function<std::optional<double>(const Vec2& at)>;

struct ToleranceOptions {
  double loss = 0.10;   ///< share of the score that may be lost
  double reach = 0.05;  ///< farthest shift looked at [m]
  double step = 0.002;  ///< between looks; a dip that is narrower may be missed [m]
};

/// How far a sensor may be sewn off its place (docs/theory/sensor_metrics.md 3.5: two numbers,
/// since a shift around a limb hurts more than one along it): shift to either side that keeps at
/// least 1 − loss of the score, the smaller of the two sides [m].
struct Tolerance {
  Vec2 direction = Vec2::UnitY();  ///< of `along` in the pattern, unit
  double along = 0, around = 0;
  /// What ended the shift: the score, the outline of the panel or the border of where sensors may
  /// be, or the reach.
  enum class End { score, outline, reach };
  End along_end = End::reach, around_end = End::reach;
};

/// Marches from `at` both ways along `direction` and across it; the crossing of the limit is
/// bisected to a micrometre. Zero where the score at `at` is zero or not known.
/// \throws InvalidInput for a zero direction or steps and reach that are not positive.
Tolerance tolerance(const FlatScore& score, const Vec2& at, const Vec2& direction,
                    const ToleranceOptions& options = {});

}  // namespace loosefit::placement
