#pragma once
#include "loosefit/kinds/shirt/shirt_values.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::kinds {

// All of these throw ShirtRefusal.

/// Ranges of every size and fit; names key, value and range.
void check_shirt_input(const ShirtMeasures& measures, const ShirtFit& fit);
/// No cap can be drafted: says how far the sleeve may be widened for this armhole length and
/// this girth of the arm [m].
[[noreturn]] void throw_sleeve_too_wide(const ShirtMeasures& measures, const ShirtFit& fit,
                                        double arm, double armhole);
/// Shoulder, underarm, waist and hem must follow each other downwards (y below the high point
/// shoulder, negative).
void check_shirt_levels(const ShirtMeasures& measures, const ShirtFit& fit, double shoulder_y,
                        double underarm_y);
/// Combinations of sizes that are each plausible but do not make a garment together.
void check_shirt_outlines(const pattern::Pattern& shirt, const ShirtMeasures& measures,
                          const ShirtFit& fit, double shoulder_x, double under_length);

}  // namespace loosefit::kinds
