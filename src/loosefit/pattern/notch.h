#pragma once

namespace loosefit::pattern {

/// A mark at the cut edge that comes to lie on a mark of the edge it is sewn to.
struct Notch {
  int panel = 0;     ///< index into Pattern::panels
  int edge = 0;      ///< index into Panel::edges
  double along = 0;  ///< share of the arc length from the edge's start, 0 to 1
};

}  // namespace loosefit::pattern
