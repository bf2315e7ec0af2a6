#pragma once
#include <string>
#include <vector>

#include "loosefit/placement/line_place.h"

namespace loosefit::placement {

/// A sensor that is a line: a stretch sensor, a lead, a textile conductor. It runs from the first
/// of its stops to the last one.
struct LineSpec {
  std::vector<LinePlace> stops;  ///< at least two
  /// From stop to stop: the shortest way in the cloth as cut, across seams; the straight line of
  /// one piece of the pattern; or the way that is stretched least in all postures and donnings.
  enum class Course { shortest, straight, least_strain } course = Course::shortest;
  /// Side of the body that the way between two stops leads over: front, back, left, right, and of
  /// limbs inside and outside; empty: the shortest.
  std::string over = {};
  double height = 0;       ///< of its middle above the middle of the cloth, outwards [m]
  double pre_stretch = 0;  ///< by which it is stretched when sewn on [–]
  double part = 0.010;     ///< wished length of the parts in which it is told [m]
};

}  // namespace loosefit::placement
