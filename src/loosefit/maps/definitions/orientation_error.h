#pragma once
#include "loosefit/maps/map_definition.h"

namespace loosefit::maps {

/// What an orientation sensor reads wrong after calibration (maps/orientation_error.h).
inline MapDefinition orientation_error_map() {
  constexpr double kRange = 20;  // beyond 15° a sensor only tells posture classes apart [deg]
  MapArray rms{
      .style = {.array = "coe_rms_deg",
                .title = "Calibrated orientation error, RMS over postures",
                .unit = "deg",
                .range_high = kRange,
                .map = "orientation-error"},
      .meaning =
          "How far an orientation sensor that was calibrated in the first posture reads "
          "wrong in the others: the angle of E = R Rᵣᵀ, with R the rotation of cloth against "
          "skin now and Rᵣ then; root mean square over the postures of the first donning.",
      .formula = "√(Σ angle(R Rᵣᵀ)² / n)",
      .source = "docs/theory/sensor_metrics.md 3.3",
      .read = ReadError([](const ErrorSummary& error) { return error.rms; }),
      .in_unit = in_degrees,
      .metrics = {
          {"coe_rms_deg", "calibrated orientation error, RMS over postures", OverFootprint::rigid,
           OverStates::error_rms},
          {"coe_across_deg",
           "turn about the sensor's axis across it, in the posture of the greatest error",
           OverFootprint::rigid, OverStates::turn_across},
          {"coe_along_deg",
           "turn about the sensor's own axis, in the posture of the greatest error",
           OverFootprint::rigid, OverStates::turn_along},
          {"coe_normal_deg", "turn about the cloth's normal, in the posture of the greatest error",
           OverFootprint::rigid, OverStates::turn_normal},
          {"donning_coe_deg", "orientation error from one donning to the next",
           OverFootprint::rigid, OverStates::error_of_donnings}}};
  MapArray p95{.style = {.array = "coe_p95_deg",
                         .title = "Calibrated orientation error, 95 % of postures",
                         .unit = "deg",
                         .range_high = kRange,
                         .map = "orientation-error-p95",
                         .pictured = false},
               .meaning =
                   "The least angle that 95 % of those postures do not exceed; of few, the "
                   "greatest.",
               .formula = "95th percentile of angle(R Rᵣᵀ)",
               .source = "docs/theory/sensor_metrics.md 3.3",
               .read = ReadError([](const ErrorSummary& error) { return error.p95; }),
               .in_unit = in_degrees,
               .metrics = {{"coe_p95_deg", "calibrated orientation error, 95 % of postures",
                            OverFootprint::rigid, OverStates::error_p95}}};
  return {.name = "orientation-error", .arrays = {rms, p95}, .needs_postures = true};
}

}  // namespace loosefit::maps
