#pragma once
#include "loosefit/maps/map_definition.h"

namespace loosefit::maps {

/// Angle between the cloth and the body under it.
inline MapDefinition angular_deviation_map() {
  return {.name = "angular-deviation",
          .arrays = {{.style = {.array = "angular_deviation_deg",
                                .title = "Angular deviation",
                                .unit = "deg",
                                .range_high = 40,
                                .map = "angular-deviation"},
                      .meaning = "Angle between the garment's normal and the smooth body normal at "
                                 "the nearest point: an orientation sensor sewn there shows the "
                                 "body's inclination wrongly by at most this much, as long as "
                                 "nothing is calibrated away.",
                      .formula = "AD = atan2(|n_g × n_b|, n_g · n_b)",
                      .source = "Harms, Amft and Tröster 2012, section 2.2",
                      .read = ReadOverSkin([](const ClothOverSkin& at) {
                        return angle_between(at.normal, at.partner.normal);
                      }),
                      .in_unit = in_degrees,
                      .rigid = [](const Orientation& o) { return o.angular_deviation; },
                      .metrics = {{"angular_deviation_deg", "angle between garment and body normal",
                                   OverFootprint::rigid, OverStates::reference}}}},
          .by_default = true};
}

}  // namespace loosefit::maps
