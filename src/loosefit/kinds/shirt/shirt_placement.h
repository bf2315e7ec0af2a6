#pragma once
#include "loosefit/kinds/shirt/shirt_values.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::kinds {

/// Where the flat pieces are placed in space for other tools (ours arranges them on the body).
struct ShirtPlacement {
  double hps_height = 0;  ///< high point shoulder above the floor [m]; 0 = 3.3 hps_to_waist
  double arm_abduction = 0.4363323129985824;  ///< upper arm to the downward vertical [rad]; 25°
};

/// Flat placement in front of and behind the body, sleeves turned by the arm angle.
void place_shirt(pattern::Pattern& shirt, const ShirtMeasures& measures,
                 const ShirtPlacement& placement, const Vec2& shoulder_point, double cap_height);

}  // namespace loosefit::kinds
