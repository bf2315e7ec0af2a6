#pragma once
#include "loosefit/body/body.h"

namespace loosefit::support {

/// The measures of the adult woman of the pattern reference (docs/theory/patterns.md 1).
inline body::Body measured_woman() {
  body::Body body;
  body.measured = {{"chest", .880},
                   {"waist", .720},
                   {"hip", .960},
                   {"neck", .360},
                   {"upper_arm", .284},
                   {"wrist", .160},
                   {"shoulder_breadth", .385},
                   {"shoulder_slope", radians(20)},
                   {"scye_depth", .145},
                   {"hps_to_waist", .425},
                   {"hps_to_hip", .630},
                   {"arm_length", .585}};
  return body;
}

}  // namespace loosefit::support
