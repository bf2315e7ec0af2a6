#pragma once
#include <vector>

#include "loosefit/pattern/pattern.h"

namespace loosefit::pattern {

/// A run of curves from `start`; knots[i] is the end of curves[i].
struct CurveChain {
  Vec2 start;
  std::vector<EdgeCurve> curves;
  std::vector<Vec2> knots;

  const Vec2& end() const { return knots.back(); }
  CurveChain& line_to(const Vec2& p);
  CurveChain& cubic_to(const Vec2& c1, const Vec2& c2, const Vec2& p);
  double length(int pieces = 64) const;
  CurveChain reversed() const;
  CurveChain mirrored() const;  ///< under x → -x
};

}  // namespace loosefit::pattern
