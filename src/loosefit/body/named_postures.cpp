#include "loosefit/body/named_postures.h"

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/body/joint_postures.h"

namespace loosefit::body {
namespace {

Posture arms(double aside, double forward) {
  Posture posture;
  posture.arm_abduction = radians(aside);
  posture.arm_flexion = radians(forward);
  posture.elbow_extension = 1;
  return posture;
}

// The arms hang: they are as far forward of the trunk as it leans.
Posture bend(double lean) {
  Posture posture = kStanding;
  posture.forward_bend = posture.arm_flexion = radians(lean);
  return posture;
}

Posture lean_with_arms_along() {
  Posture posture = kStanding;
  posture.forward_bend = radians(30);
  return posture;
}

// The forearms lie along the thighs.
Posture sitting() {
  Posture posture = kStanding;
  posture.sitting = 1;
  posture.elbow_extension = 0;
  posture.arm_flexion = radians(15);
  return posture;
}

Posture slouch() {
  Posture posture = kStanding;
  posture.slouch = 1;
  posture.arm_flexion = radians(25);
  return posture;
}

// The left heel strikes.
Posture stride() {
  Posture posture = kStanding;
  posture.left_hip_flexion = radians(25);
  posture.right_hip_flexion = radians(-10);
  posture.right_knee_flexion = radians(15);
  return posture;
}

// The left foot is on the next step.
Posture stair_climb() {
  Posture posture = kStanding;
  posture.left_hip_flexion = radians(65);
  posture.left_knee_flexion = radians(85);
  return posture;
}

// The arms keep the balance: level, though the trunk leans.
Posture squat() {
  Posture posture = arms(10, 120);
  posture.forward_bend = radians(30);
  posture.hip_flexion = radians(90);
  posture.knee_flexion = radians(100);
  return posture;
}

}  // namespace

const std::vector<std::pair<std::string, Posture>>& named_postures() {
  static const std::vector<std::pair<std::string, Posture>> kTable = {
      {"standing", kStanding},
      {"model-standing", {}},
      {"a-pose", kArmsApart},
      {"arms-forward", arms(10, 90)},
      {"arms-overhead", arms(20, 160)},
      {"forward-bend", lean_with_arms_along()},
      {"forward-bend-15", bend(15)},
      {"forward-bend-30", bend(30)},
      {"forward-bend-45", bend(45)},
      {"sitting", sitting()},
      {"slouch", slouch()},
      {"stride", stride()},
      {"stair-climb", stair_climb()},
      {"squat", squat()},
  };
  return kTable;
}

std::vector<std::string> posture_names() {
  std::vector<std::string> names;
  for (const auto& entry : named_postures()) names.push_back(entry.first);
  return names;
}

Posture named_posture(const std::string& name) {
  const std::size_t plus = name.find('+');
  for (const auto& [known, posture] : named_postures()) {
    if (known == name) return posture;
    if (plus == std::string::npos || name.substr(0, plus) != known) continue;
    const std::string joints = name.substr(plus + 1);
    const auto angles = joint_angles(joints);
    if (!angles)
      throw InvalidInput({"", 0, "posture"}, "\"" + printable(joints) + "\" behind " + known,
                         "joints with their angles in degrees, as in sitting+elbow-flexion-90", "");
    for (const JointAngle& angle : *angles)
      if (posture.sitting > 0 && (angle.joint.find("hip-") != std::string::npos ||
                                  angle.joint.find("knee-") != std::string::npos))
        throw InvalidInput(
            {"", 0, "posture"}, "\"" + printable(name) + "\"",
            "joints of the arms, the trunk or the wrists: " + known + " tells where the legs are",
            "");
    return joint_posture(*angles, posture);
  }
  if (const auto angles = joint_angles(name)) return joint_posture(*angles);
  throw InvalidInput({"", 0, "posture"}, "\"" + printable(name) + "\"", "the name of a posture",
                     did_you_mean(name, posture_names()));
}

}  // namespace loosefit::body
