#pragma once
#include <map>
#include <string>
#include <vector>

#include "loosefit/lines/line_state.h"

namespace loosefit::lines {

/// The signal of a line in one state against the posture in which it is calibrated, in the same
/// donning: length / length there − 1. NaN where that donning has no such state.
std::vector<double> signals(const std::vector<LineState>& states, int reference_posture = 0);

/// The numbers by which a line is judged (placement::line_vocabulary), units in their names, over
/// the states of one donning; each donning by itself, in ascending order. What the states do not
/// tell is left out.
///
/// - line_elongation: in the reference posture; line_elongation_most, line_elongation_least
/// - line_part_elongation: greatest of any part; line_part_strain: the same either way
/// - line_swing, line_swing_mm: greatest less least of the signal, and of the length; several
///   postures
/// - line_force_N: greatest tension, of what is told of its stiffness
/// - line_slack: greatest; line_contact: least
/// - line_bend_radius_mm: least; left out where it never bends
/// - line_donning_shift: reference length against that of the first donning, as a share of the
///   length in the flat cloth; several donnings
std::vector<std::map<std::string, double>> line_metrics_by_donning(
    const std::vector<LineState>& states, double cut_length, int reference_posture = 0);

}  // namespace loosefit::lines
