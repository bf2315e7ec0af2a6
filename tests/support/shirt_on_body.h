#pragma once
#include "loosefit/kinds/shirt/shirt_draft.h"
#include "support/body_fixture.h"

namespace loosefit::support {

/// Parameters of an average woman of 25 and of a slim child of ten (docs/theory/body_model.md 6).
inline body::BodyParameters adult_parameters() {
  body::BodyParameters p;
  p.sex = 0;
  return p;
}
inline body::BodyParameters slim_child_parameters() {
  body::BodyParameters p;
  p.sex = 0.4;
  p.age = 10;
  p.height = 0.5872;
  p.weight = 0.0602;
  p.details = {{"bust", -0.2103},
               {"underbust", -0.0646},
               {"waist", -0.3217},
               {"hips", -0.5672},
               {"belly", -0.0110}};
  return p;
}

/// Standing with the arms so many degrees from the vertical.
inline body::Body standing(const body::BodyParameters& parameters, double arm_degrees) {
  return body_model().build(parameters, {radians(arm_degrees), 0, 0});
}

/// The shirt drafted for this body with the same fit at chest and hip.
inline pattern::Pattern shirt_for(const body::Body& body, double fit, double sleeve_length = 1) {
  const auto of = [&](const char* name) { return body.measured.at(name); };
  const kinds::ShirtMeasures measures = {.chest = of("chest"),
                                         .waist = of("waist"),
                                         .hip = of("hip"),
                                         .neck = of("neck"),
                                         .upper_arm = of("upper_arm"),
                                         .wrist = of("wrist"),
                                         .shoulder_breadth = of("shoulder_breadth"),
                                         .shoulder_slope = of("shoulder_slope"),
                                         .scye_depth = of("scye_depth"),
                                         .hps_to_waist = of("hps_to_waist"),
                                         .hps_to_hem = of("hps_to_hip"),
                                         .arm_length = of("arm_length")};
  kinds::ShirtFit ease;
  ease.chest = ease.hip = fit;
  ease.sleeve_length = sleeve_length;
  if (sleeve_length < 1) ease.cap_ratio = 0.55;  // as a T-shirt
  return kinds::draft_shirt(measures, ease);
}

}  // namespace loosefit::support
