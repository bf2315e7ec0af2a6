#pragma once
#include "loosefit/maps/map_definition.h"

namespace loosefit::maps {

/// Travel of the cloth over the skin since the reference posture (maps/skin_partner.h).
inline MapDefinition slip_map() {
  constexpr double kRange = 20;  // [mm]
  const auto part = [](const char* array, const char* title, const char* picture,
                       const char* meaning, const char* formula, ReadSlip read) {
    return MapArray{.style = {.array = array,
                              .title = title,
                              .unit = "mm",
                              .range_low = -kRange,
                              .range_high = kRange,
                              .map = picture,
                              .pictured = false,
                              .diverging = true},
                    .meaning = meaning,
                    .formula = formula,
                    .source = "docs/theory/sensor_metrics.md 7",
                    .read = read,
                    .in_unit = millimetres};
  };
  MapArray slip{
      .style = {.array = "slip_mm",
                .title = "Slip on the skin",
                .unit = "mm",
                .range_high = kRange,
                .map = "slip"},
      .meaning =
          "How far a point of the cloth has moved along the skin since the first posture, "
          "against the skin that was nearest to it there and has moved with the body since; "
          "of a case the greatest over the postures of the first donning. Single postures "
          "are in postures/NAME/drape.vtp, with the parts along and around the body segment.",
      .formula = "tangential part of the change of Fᵀ (x − p), p and F carried with the skin",
      .source = "docs/theory/sensor_metrics.md 7",
      .read = ReadSlip([](const Slip& s) { return s.distance; }),
      .in_unit = millimetres,
      .metrics = {{"slip_mm", "travel along the skin over postures", OverFootprint::rigid,
                   OverStates::greatest_change}}};
  return {
      .name = "slip",
      .arrays = {slip,
                 part("slip_along_mm", "Slip along the segment", "slip-along",
                      "The part of the slip along the body segment, positive to its near end.",
                      "its component along a", [](const Slip& s) { return s.along; }),
                 part("slip_around_mm", "Slip around the segment", "slip-around",
                      "The part around the segment, on the back positive to the wearer's right.",
                      "its component along s", [](const Slip& s) { return s.around; })},
      .needs_postures = true};
}

}  // namespace loosefit::maps
