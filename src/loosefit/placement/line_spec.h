#pragma once
#include <string>
#include <vector>

#include "loosefit/placement/keep_out.h"
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
  // Of the way that is stretched least (lines::RouteWish).
  double longest = 0;     ///< in the flat cloth [m]; 0: any length
  double seam_price = 0;  ///< way that is as dear as to cross a seam [m]
  double bend_price = 0;  ///< strain per curvature: half the thickness of a lead [m]
  double slip_price = 0;  ///< strain per metre of slip [1/m]
  KeepOut keep_out = {};  ///< where it must not run
  /// By what it is judged: name or path of a scorecard of lines; empty: all that are shipped.
  std::string scorecard = {};
  // What it does to the garment; nothing: it only measures.
  double stiffness = 0;       ///< of the whole: force per metre by which it is longer [N/m]
  double width = 0.01;        ///< of the cloth on which it pulls [m]
  double linear_density = 0;  ///< [kg/m]
  double bending = 0;         ///< [N m²]
  /// EA of a line that is so long in the flat cloth [N].
  double axial_stiffness(double cut_length) const {
    return stiffness * cut_length / (1 + pre_stretch);
  }
  /// It is a part of the garment, so that its course must be known before the garment is draped.
  bool is_sewn_part() const { return stiffness > 0 || linear_density > 0 || bending > 0; }
};

}  // namespace loosefit::placement
