#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/body/register_person.h"
#include "loosefit/body/scan_frame.h"

namespace loosefit::body {

/// Somebody's scan as a person of the model, whose skin lies on it.
struct ScanPerson {
  Body body;  ///< as scanned: in the scan's pose, from_world included
  BodyParameters parameters;
  /// The nearest posture with both sides alike: upright, arms as far aside as the scan's on
  /// average.
  Posture posture;
  RegistrationError error;
  std::vector<std::string> warnings;
};

/// Checks a surface as check_surface does, but with holes of up to 12 % of the stature and 5 % of
/// the skin, which the model knows more of, and lays the model on it (register_person). Nothing
/// where the surface is not one person that the model can be laid on within kMostOff: who asked for
/// less than a person then says why. \throws InvalidInput as check_surface does, and for a person
/// in clothes that stand off the skin.
std::optional<ScanPerson> person_from_scan(const BodyModel& model, geometry::TriangleMesh mesh,
                                           ScanOptions options);

/// The most that skin and scan may be apart in the median and at the 95th percentile [m]: what a
/// tape can tell, and the reach of the shifts' noise.
inline constexpr RegistrationError kMostOff{0.003, 0.010};

}  // namespace loosefit::body
