#pragma once
#include <iterator>

#include "loosefit/maps/map_definition.h"

namespace loosefit::maps {

/// Contact pressure by two independent estimates (maps/pressure.h).
inline MapDefinition pressure_map() {
  constexpr double kTop = kPressureClasses[std::size(kPressureClasses) - 1] / 1000;  // [kPa]
  constexpr double kShownDifference = 1;                                             // [kPa]
  // Below the classes, one more step for cloth that only hangs or clings: it must not look like
  // cloth that does not touch.
  std::vector<double> breaks = {0, 0.05};
  for (double bound : kPressureClasses) breaks.push_back(bound / 1000);
  MapArray contact{
      .style = {.array = "pressure_kPa",
                .title = "Contact pressure",
                .unit = "kPa",
                .range_high = kTop,
                .map = "pressure",
                .breaks = breaks,
                .decimals = 3},
      .meaning =
          "Normal force of the body on a vertex of the cloth, friction left out, over the "
          "worn area that belongs to the vertex (a third of the triangles round it). The sum "
          "of p a is the total normal force. Zero where nothing touches. The body is rigid; "
          "soft tissue would spread the peaks, so read means over a footprint and not single "
          "points.",
      .formula = "p = f / a",
      .source = "docs/theory/validation.md 6.2",
      .read = ReadField([](const MapInput& in) { return in.pressure->contact; }),
      .in_unit = kilopascals,
      .metrics = {{"pressure_kPa", "contact pressure"},
                  {"pressure_min_kPa", "lowest contact pressure over postures", OverFootprint::mean,
                   OverStates::least_posture},
                  {"pressure_swing_kPa", "range of the contact pressure over postures",
                   OverFootprint::mean, OverStates::swing}}};
  MapArray membrane{
      .style = {.array = "pressure_membrane_kPa",
                .title = "Contact pressure from tension and curvature",
                .unit = "kPa",
                .range_high = kTop,
                .map = "pressure-membrane",
                .pictured = false,
                .breaks = breaks,
                .decimals = 3,
                .companion = true},
      .meaning =
          "Membrane tension per worn length N = F S Fᵀ / J against the curvature tensor κ of "
          "the body under the cloth, carried out to the cloth's middle surface and positive "
          "where the body is convex, plus the weight per worn area w along the normal; not "
          "below zero. Where the body is flat or hollow along the pull it is zero: the cloth "
          "bridges. Zero also where the gap exceeds the contact tolerance, the larger of "
          "0.5 mm and three quarters of the fabric's thickness.",
      .formula = "p = max(0, N : κ + w n_z)",
      .source = "generalised Laplace law, docs/theory/validation.md 6.2",
      .read = ReadField([](const MapInput& in) { return in.pressure->membrane; }),
      .in_unit = kilopascals};
  MapArray difference{.style = {.array = "pressure_difference_kPa",
                                .title = "Pressure by tension and curvature minus contact pressure",
                                .unit = "kPa",
                                .range_low = -kShownDifference,
                                .range_high = kShownDifference,
                                .map = "pressure-difference",
                                .pictured = false,
                                .diverging = true,
                                .decimals = 3,
                                .companion = true},
                      .meaning =
                          "The second minus the first, a check of both: zero for a fine mesh "
                          "on a smooth body.",
                      .formula = "pressure_membrane_kPa − pressure_kPa",
                      .source = "docs/theory/validation.md 6.2",
                      .read = ReadField([](const MapInput& in) {
                        std::vector<double> pascals;
                        for (std::size_t v = 0; v < in.pressure->contact.size(); ++v)
                          pascals.push_back(in.pressure->membrane[v] - in.pressure->contact[v]);
                        return pascals;
                      }),
                      .in_unit = kilopascals};
  return {.name = "pressure", .arrays = {contact, membrane, difference}, .needs_forces = true};
}

}  // namespace loosefit::maps
