#pragma once
#include "loosefit/pattern/shirt_draft.h"

namespace loosefit {

/// A measure with its name and the range of people [m, rad].
struct ShirtMeasure {
  const char* name;
  double ShirtMeasures::*field;
  double low, high;
  const char* unit;  ///< for messages: " m", " rad"
};
const std::vector<ShirtMeasure>& shirt_measure_list();

// All of these throw ShirtRefusal.

/// Ranges of every size and fit; names key, value and range.
void check_shirt_input(const ShirtMeasures& measures, const ShirtFit& fit);
/// No cap can be drafted: says how far the sleeve may be widened for this armhole length [m].
[[noreturn]] void throw_sleeve_too_wide(const ShirtMeasures& measures, const ShirtFit& fit,
                                        double armhole);
/// Shoulder, underarm, waist and hem must follow each other downwards (y below the high point
/// shoulder, negative).
void check_shirt_levels(const ShirtMeasures& measures, const ShirtFit& fit, double shoulder_y,
                        double underarm_y);
/// Combinations of sizes that are each plausible but do not make a garment together.
void check_shirt_outlines(const Pattern& shirt, const ShirtMeasures& measures, const ShirtFit& fit,
                          double shoulder_x, double under_length);
/// Flat placement in front of and behind the body, sleeves turned by the arm angle.
void place_shirt(Pattern& shirt, const ShirtMeasures& measures, const ShirtPlacement& placement,
                 const Vec2& shoulder_point, double cap_height);

}  // namespace loosefit
