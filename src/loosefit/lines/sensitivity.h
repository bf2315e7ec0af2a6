#pragma once
#include <map>
#include <string>
#include <vector>

#include "loosefit/lines/line_state.h"

namespace loosefit::lines {

/// The signal of a line at one angle of a joint, over donnings.
struct CurvePoint {
  double degrees = 0;
  std::vector<double> signals;     ///< one per donning that has the state, ascending [–]
  double mean = 0, deviation = 0;  ///< sample standard deviation; 0 of one donning
};

/// What a joint other than the one that is measured does to the signal.
struct CrossEffect {
  std::string posture;  ///< in which it is turned
  double change = 0;    ///< mean of the signal against the same posture without that joint [–]
  double degrees = 0;   ///< of the measured joint that would do the same; NaN without a gain
};

/// How a line sees one joint (docs/theory/lines.md 4).
struct Sensitivity {
  std::string joint;              ///< body::JointMotion::name
  std::vector<CurvePoint> curve;  ///< by ascending angle
  /// Slope of the straight line that fits the means best [1/degree].
  double gain = 0;
  /// The widest range of angles over which every donning's signal changes in one direction, by
  /// more than round-off at each step [degrees]; both the same: there is none.
  double monotone_from = 0, monotone_to = 0;
  bool rises = true;  ///< there
  /// Over that range: from one donning to another, RMS of the deviation of the signal over the
  /// slope of the mean there [degrees]: how well the angle is known without calibrating anew after
  /// a donning beyond the reference posture. NaN for one donning or without a range.
  double angle_error = 0;
  std::vector<CrossEffect> cross;
};

/// What a sensitivity adds to the numbers by which a line is judged: line_gain_percent_per_deg,
/// line_monotone_share of the swept range, and line_angle_error_deg where it is known.
std::map<std::string, double> sensitivity_metrics(const Sensitivity& sensitivity);

/// For every joint of which the list of postures has at least three angles with nothing else turned
/// (joint_postures.h). `signals`: per state, as line_metrics.h gives them; NaN is passed over.
/// Cross effects are of postures that turn other joints, alone or beside this one, for which the
/// posture without them is on the list: "standing" where nothing is left.
std::vector<Sensitivity> sensitivities(const std::vector<std::string>& postures,
                                       const std::vector<LineState>& states,
                                       const std::vector<double>& signals);

}  // namespace loosefit::lines
