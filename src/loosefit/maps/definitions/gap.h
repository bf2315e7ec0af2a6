#pragma once
#include "loosefit/maps/gap.h"
#include "loosefit/maps/map_definition.h"

namespace loosefit::maps {

/// Gap under the cloth, and whether it touches (maps/gap.h).
inline MapDefinition gap_map() {
  MapArray gap{
      .style =
          {.array = "gap_mm",
           .title = "Gap between the cloth's inner face and the skin",
           .unit = "mm",
           .range_high = 40,
           .map = "gap",
           // Fine where electrodes and temperature sensors live, coarse where cloth hangs free.
           .breaks = {0, 0.5, 2, 5, 10, 20, 40}},
      .meaning =
          "From the cloth's inner face to the skin. The colour bar goes in equal steps "
          "through 0, 0.5, 2, 5, 10, 20 and 40 mm.",
      .formula = "max(0, distance − ½ thickness)",
      .source = "docs/theory/sensor_metrics.md 4",
      .read = ReadOverSkin(
          [](const ClothOverSkin& at) { return gap_of(at.partner.exact.distance, *at.material); }),
      .in_unit = millimetres,
      .metrics = {{"gap_mm", "gap to the skin, mean of the footprint"},
                  {"gap_worst_mm", "gap to the skin, worst 5 % of the footprint",
                   OverFootprint::highest, OverStates::greatest},
                  {"gap_swing_mm", "range of the gap over postures", OverFootprint::mean,
                   OverStates::swing}}};
  MapArray contact{.style = {.array = "contact",
                             .title = "Contact with the skin",
                             .map = "contact",
                             .pictured = false,
                             .companion = true},
                   .meaning =
                       "1 at vertices that bear a contact force, or whose gap is within the "
                       "contact tolerance, else 0; the area mean is the share of the cloth that "
                       "touches. A flat triangle that lies on a convex body touches within and "
                       "stands off at its corners: the smooth cloth that it stands for touches.",
                   .formula = "p > 0 or gap ≤ max(0.5 mm, ¾ thickness)",
                   .source = "docs/theory/sensor_metrics.md 4",
                   .read = ReadField([](const MapInput& in) {
                     const bool known = in.pressure && !in.pressure->empty();
                     std::vector<double> touching;
                     for (std::size_t v = 0; v < in.worn.partners.size(); ++v) {
                       const double below =
                           gap_of(in.worn.partners[v].exact.distance, *in.material);
                       const bool bears = known && in.pressure->contact[v] > 0;
                       touching.push_back(bears || touches(below, *in.material) ? 1 : 0);
                     }
                     return touching;
                   }),
                   .metrics = {{"contact_ratio", "share of the footprint that touches the skin",
                                OverFootprint::mean, OverStates::least},
                               {"contact_duty", "share of postures with at least 0.9 in contact",
                                OverFootprint::mean, OverStates::contact_duty}}};
  return {.name = "gap", .arrays = {gap, contact}, .needs_material = true};
}

}  // namespace loosefit::maps
