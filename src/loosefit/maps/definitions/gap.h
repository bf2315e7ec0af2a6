#pragma once
#include <limits>

#include "loosefit/maps/gap.h"
#include "loosefit/maps/map_definition.h"

namespace loosefit::maps {

/// Gap under the cloth, and whether it touches (maps/gap.h) or is pressed on.
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
          "From the inner face of the smooth cloth, or of a board inside it, to the skin. The "
          "colour bar goes in equal steps "
          "through 0, 0.5, 2, 5, 10, 20 and 40 mm.",
      .formula = "max(0, distance − ½ thickness − board inside)",
      .source = "docs/theory/sensor_metrics.md 4",
      .read = ReadOverSkin(
          [](const ClothOverSkin& at) { return gap_of(at.distance - at.padding, *at.material); }),
      .in_unit = millimetres,
      .metrics = {{"gap_mm", "gap to the skin, mean of the footprint"},
                  {"gap_worst_mm", "gap to the skin, worst 5 % of the footprint",
                   OverFootprint::highest, OverStates::greatest},
                  {"gap_swing_mm", "range of the gap over postures", OverFootprint::mean,
                   OverStates::swing}}};
  MapArray contact{
      .style = {.array = "contact",
                .title = "Contact with the skin",
                .map = "contact",
                .pictured = false,
                .companion = true},
      .meaning =
          "1 where the gap of the smooth cloth is within the contact tolerance, else 0; the "
          "area mean is the share of the cloth that touches. What optical sensors need.",
      .formula = "gap ≤ max(0.5 mm, ¾ thickness)",
      .source = "docs/theory/sensor_metrics.md 4",
      .read = ReadOverSkin([](const ClothOverSkin& at) {
        return touches(gap_of(at.distance - at.padding, *at.material), *at.material) ? 1.0 : 0.0;
      }),
      .metrics = {{"contact_ratio", "share of the footprint that touches the skin",
                   OverFootprint::mean, OverStates::least},
                  {"contact_duty", "share of postures with at least 0.9 in contact",
                   OverFootprint::mean, OverStates::contact_duty}}};
  MapArray pressed{
      .style = {.array = "pressed",
                .title = "Pressed on the skin",
                .map = "pressed",
                .pictured = false,
                .companion = true},
      .meaning =
          "1 at vertices that the skin bears with at least 0.05 kPa, else 0. What electrodes "
          "need: cloth that only lies near by carries no current.",
      .formula = "p ≥ 0.05 kPa",
      .source = "docs/theory/sensor_metrics.md 4",
      .read = ReadField([](const MapInput& in) {
        constexpr double kLeast = 50;  // [Pa]
        const bool known = in.pressure && !in.pressure->empty();
        std::vector<double> pressed_at;
        for (std::size_t v = 0; v < in.worn.partners.size(); ++v)
          pressed_at.push_back(!known ? std::numeric_limits<double>::quiet_NaN()
                                      : (in.pressure->contact[v] >= kLeast ? 1.0 : 0.0));
        return pressed_at;
      }),
      .metrics = {{"pressed_ratio", "share of the footprint that is pressed on the skin",
                   OverFootprint::mean, OverStates::least},
                  {"pressed_duty", "share of postures with at least 0.9 pressed",
                   OverFootprint::mean, OverStates::contact_duty}}};
  return {.name = "gap", .arrays = {gap, contact, pressed}, .needs_material = true};
}

}  // namespace loosefit::maps
