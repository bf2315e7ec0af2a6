#pragma once
#include "loosefit/body/posed_person.h"

namespace loosefit::body {

/// How far the surfaces of a registered person and of a scan are from each other [m], on what
/// garments cover: neck, trunk, arms and legs, without head, hands and feet.
struct RegistrationError {
  double median = 0;
  double p95 = 0;
};

/// A person of the model who looks and stands like somebody's scan.
struct RegisteredPerson {
  PosedPerson person;          ///< its parameters hold the shift to the scan's own skin
  RegistrationError of_model;  ///< before the shift: the nearest person of the model
  RegistrationError error;
};

}  // namespace loosefit::body
