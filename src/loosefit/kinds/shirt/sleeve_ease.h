#pragma once
#include <vector>

#include "loosefit/kinds/fit_stations.h"
#include "loosefit/kinds/shirt/shirt_values.h"

namespace loosefit::kinds {

// How wide a sleeve is along the arm. Lengths are from the shoulder point [m]; `underarm` is where
// the cap ends.

/// Girth of the arm: that of the body's stations where they are known, else even between the levels
/// that a table of sizes has. Above the first place its girth holds, below the wrist the wrist's.
double arm_girth(const ShirtMeasures& measures, double along);
/// The same at a share of the way from the shoulder point to the wrist.
double arm_girth_at(const ShirtMeasures& measures, double share);

/// Girth of the arm that `sleeve` counts against [m]: that at the underarm, and as far as
/// sleeve_follow is below 1, or where no girths along the arm are known, that of the upper arm.
double arm_under_sleeve(const ShirtMeasures& measures, const ShirtFit& fit, double underarm);

/// Where a sleeve without its cuff ends.
double sleeve_end(const ShirtMeasures& measures, const ShirtFit& fit);

/// Whether a sleeve covers elbow and forearm.
bool has_elbow(const ShirtMeasures& measures, const ShirtFit& fit, double underarm);

/// The mobilities asked for, from the underarm down to the end of the sleeve; at the seam of a cuff
/// that is sewn on stretched the sleeve's own.
std::vector<AskedMobility> sleeve_eases(const ShirtMeasures& measures, const ShirtFit& fit,
                                        double underarm);

/// Girth of the sleeve at places below the underarm, the last one its end. Each has its asked ease;
/// as far as sleeve_follow is below 1 it is as wide as an even taper where that leaves more room,
/// and no narrower than nearer to the hand.
GirthLine sleeve_girths(const ShirtMeasures& measures, const ShirtFit& fit, double underarm);

}  // namespace loosefit::kinds
