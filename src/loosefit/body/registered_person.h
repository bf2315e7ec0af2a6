#pragma once
#include <vector>

#include "loosefit/body/missing_limb.h"
#include "loosefit/body/posed_person.h"

namespace loosefit::body {

/// How far the surfaces of a registered person and of a scan are from each other [m], on what
/// garments cover: neck, trunk, arms and legs, without head, hands and feet.
struct RegistrationError {
  double median = 0;
  double p95 = 0;
};

/// How much of a scan lies outside the nearest person of the model, of what garments cover: cloth
/// stands off the skin, while the skin of unlike people lies inside as often as outside.
struct StandOff {
  double share = 0;               ///< that is farther outside than kStandOff
  Segment most = Segment::torso;  ///< which has the largest share of its own
  double most_share = 0;          ///< that
  double neck_seen = 0;           ///< share of the model's neck over which the scan has skin
  double neck_share = 0;          ///< of what is seen of the neck
};
inline constexpr double kStandOff = 0.010;  ///< [m]

/// A person of the model who looks and stands like somebody's scan.
struct RegisteredPerson {
  PosedPerson person;          ///< its parameters hold the shift to the scan's own skin
  RegistrationError of_model;  ///< before the shift: the nearest person of the model
  StandOff stand_off;          ///< before the shift, too
  RegistrationError error;
  std::vector<MissingLimb> missing;   ///< the person has BodyParameters::stumps there
  std::vector<ShortFoot> short_feet;  ///< whose forefoot is the model's
  bool hands_left_out = false;  ///< one is missing in the scan or held another way: neither counted
};

}  // namespace loosefit::body
