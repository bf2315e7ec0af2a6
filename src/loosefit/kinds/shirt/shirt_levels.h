#pragma once
#include <vector>

#include "loosefit/kinds/kind.h"

namespace loosefit::kinds {

/// Girths of a shirt, measured on its pieces [m]: chest, hip (hem),
/// sleeve, wrist, waist (at `hps_to_waist` below the high point shoulder). Missing pieces are left
/// out.
NamedValues shirt_girths(const pattern::Pattern& shirt, double hps_to_waist);

/// The levels of fit of a shirt with or without sleeves, as GarmentKind::levels: chest, waist, hip,
/// sleeve against the arm below the armhole (arm_under_sleeve), and wrist; below a sleeve length of 1 the cuff, against the arm
/// where it ends.
std::vector<FitLevel> shirt_levels(const pattern::Pattern& shirt, const BodyMeasures& measures,
                                   const NamedValues& fit);

/// As GarmentKind::stations: the trunk from underarm to hem, and the left sleeve if there is one.
std::vector<FitStation> shirt_stations(const pattern::Pattern& shirt,
                                       const BodyMeasures& measures, const NamedValues& fit);

}  // namespace loosefit::kinds
