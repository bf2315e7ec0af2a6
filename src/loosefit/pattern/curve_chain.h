#pragma once
#include <utility>
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
  /// The parts before and after a point that lies so far along [m], 0 < arc < length(); a joint
  /// between two curves that lies there is where they part.
  std::pair<CurveChain, CurveChain> cut(double arc) const;
  /// Length along the chain to where x (axis 0) or y (1) has fallen to `level` [m].
  /// \pre it falls through that level once, between its ends.
  double length_until(int axis, double level) const;
  CurveChain reversed() const;
  CurveChain mirrored() const;  ///< under x → -x
  /// Turned about a point [rad], counter-clockwise.
  CurveChain turned(const Vec2& about, double angle) const;
};

}  // namespace loosefit::pattern
