#pragma once
#include "loosefit/maps/map_definition.h"

namespace loosefit::maps {

/// How the grain of the cloth stands against the long axis of the body segment
/// (maps/orientation.h).
inline MapDefinition orientation_map() {
  constexpr double kTiltRange = 30, kRotationRange = 40;  // [deg]
  const auto array = [](const char* name, const char* title, const char* picture,
                        ReadOrientation read) {
    return MapArray{.style = {.array = name,
                              .title = title,
                              .unit = "deg",
                              .range_low = -kTiltRange,
                              .range_high = kTiltRange,
                              .map = picture,
                              .diverging = true},
                    .meaning = {},
                    .source = "docs/theory/sensor_metrics.md 3.2",
                    .read = read,
                    .in_unit = in_degrees,
                    .rigid = read};
  };
  MapArray sagittal =
      array("tilt_sagittal_deg", "Tilt about the axis across the segment",
            "orientation-tilt-sagittal", [](const Orientation& o) { return o.tilt_sagittal; });
  sagittal.meaning =
      "The shortest rotation that takes the body's normal to the cloth's, its part about the axis "
      "across the body segment: positive where the cloth's normal leans to the far end of the "
      "segment, on the trunk down. A posture sensor on the back is wrong by this. The four arrays "
      "are not defined where the segment's axis lies within 15° of the normal, as on top of the "
      "shoulders, nor where the joints are not known.";
  sagittal.formula = "τ · s, τ the rotation vector from n_b to n_g, |τ| = AD";
  sagittal.metrics = {
      {"tilt_sagittal_deg", "tilt about the axis across the segment", OverFootprint::rigid,
       OverStates::reference},
      {"tilt_across_deg", "tilt about the sensor's axis across it", OverFootprint::rigid,
       OverStates::reference, [](const Orientation& o) { return o.tilt_across(); }}};
  MapArray lateral =
      array("tilt_lateral_deg", "Tilt about the segment's long axis", "orientation-tilt-lateral",
            [](const Orientation& o) { return o.tilt_lateral; });
  lateral.meaning =
      "The part of the same rotation about the segment's long axis: positive on the back to the "
      "wearer's right, on the breast to the left.";
  lateral.formula = "τ · a";
  lateral.metrics = {{"tilt_lateral_deg", "tilt about the segment's long axis",
                      OverFootprint::rigid, OverStates::reference},
                     {"tilt_along_deg", "tilt about the sensor's own axis", OverFootprint::rigid,
                      OverStates::reference, [](const Orientation& o) { return o.tilt_along(); }}};
  MapArray twist = array("twist_deg", "Twist about the normal", "orientation-twist",
                         [](const Orientation& o) { return o.twist; });
  twist.meaning =
      "What rotation is left after the tilt: the grain of the cloth against the long axis of the "
      "body segment (trunk upwards, elbow to shoulder, wrist to elbow), positive counter-clockwise "
      "seen from outside. The angular deviation does not see it.";
  twist.formula = "angle about n_b of R after the tilt is taken out, R = F_bᵀ F_g";
  twist.metrics = {{"twist_deg", "rotation about the normal", OverFootprint::rigid,
                    OverStates::reference_angle}};
  MapArray rotation = array("rotation_deg", "Total rotation against the body", "orientation",
                            [](const Orientation& o) { return o.rotation; });
  rotation.style.range_low = 0;
  rotation.style.range_high = kRotationRange;
  rotation.style.diverging = false;
  rotation.meaning =
      "Angle of tilt and twist together. No direction that is fixed in a sensor reads wrong by "
      "more, as long as nothing is calibrated away.";
  rotation.formula = "cos φ/2 = cos AD/2 · cos twist/2";
  rotation.metrics = {{"rotation_deg", "total rotation of the sensor against the body",
                       OverFootprint::rigid, OverStates::reference}};
  return {.name = "orientation", .arrays = {sagittal, lateral, twist, rotation}};
}

}  // namespace loosefit::maps
