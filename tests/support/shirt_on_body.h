#pragma once
#include "loosefit/kinds/body_measures.h"
#include "loosefit/kinds/registry.h"
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
  const kinds::GarmentKind& shirt = kinds::garment_kind("long-sleeve-shirt");
  const kinds::ShirtMeasures measures =
      kinds::shirt_measures_of(kinds::known_measures(shirt, body.measured));
  kinds::ShirtFit ease = kinds::usual_shirt_fit();
  ease.chest = ease.hip = fit;
  ease.sleeve_length = sleeve_length;
  if (sleeve_length < 1) ease.cap_ratio = 0.55;  // as a T-shirt
  return kinds::draft_shirt(measures, ease);
}

}  // namespace loosefit::support
