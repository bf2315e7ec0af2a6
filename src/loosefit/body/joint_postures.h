#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/body/body.h"

namespace loosefit::body {

/// A joint that can be turned by itself, both sides alike unless it is of one side; all else stands
/// as in kStanding.
///
/// | joint                     | degrees   | 0 is           | positive                       |
/// |---------------------------|-----------|----------------|--------------------------------|
/// | elbow-flexion             | 0 … 130   | a straight arm | forearm to the upper arm       |
/// | shoulder-flexion          | −40 … 170 | the arm hangs  | arms forward and up            |
/// | shoulder-abduction        | 5 … 110   | the arm hangs  | arms aside and up              |
/// | wrist-flexion             | −70 … 80  | hand in line   | hand to the palm               |
/// | hip-flexion               | −15 … 100 | standing       | thighs forward                 |
/// | knee-flexion              | 0 … 120   | standing       | heels back                     |
/// | left-, right-hip-flexion  | as both   | standing       | that thigh                     |
/// | left-, right-knee-flexion | as both   | standing       | that heel                      |
/// | trunk-rotation            | −45 … 45  | face ahead     | shoulders to the wearer's left |
/// | side-bend                 | −35 … 35  | upright        | to the wearer's left           |
///
/// Limits lie within what healthy adults reach (Soucie et al. 2011, recalled), those of the elbow
/// and the knee where linear blend skinning pinches the skin too much to go on. Hip and knee of the
/// body model's stance are bent by about 6° and 10° already; their angles count from there.
struct JointMotion {
  std::string name;
  double low = 0, high = 0;  ///< [degrees]
  std::string about;         ///< "forearm to the upper arm"
};

const std::vector<JointMotion>& joint_motions();

/// One joint turned so far.
struct JointAngle {
  std::string joint;  ///< JointMotion::name
  double degrees = 0;
  bool operator==(const JointAngle&) const = default;
};

/// "elbow-flexion-90", "wrist-flexion--30"; several joined by "+". Angles to a tenth of a degree.
std::string joint_posture_name(const std::vector<JointAngle>& angles);

/// What such a name says; nothing for a name that does not begin with a joint. \throws
/// InvalidInput, key "posture", for an angle that is missing or out of range, a joint named twice,
/// or anything else behind a joint.
std::optional<std::vector<JointAngle>> joint_angles(const std::string& name);

/// A posture with these joints turned, each counted from standing. \pre known joints within their
/// range
Posture joint_posture(const std::vector<JointAngle>& angles, const Posture& from = kStanding);

/// Regular expression of such names, for a schema; ranges are not in it.
std::string joint_posture_pattern();

}  // namespace loosefit::body
