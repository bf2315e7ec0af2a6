#include "loosefit/body/joint_postures.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"

namespace loosefit::body {
namespace {

double Posture::*turned_by(const std::string& joint) {
  static const std::map<std::string, double Posture::*> kOf = {
      {"elbow-flexion", &Posture::elbow_flexion},
      {"shoulder-flexion", &Posture::arm_flexion},
      {"shoulder-abduction", &Posture::arm_abduction},
      {"wrist-flexion", &Posture::wrist_flexion},
      {"hip-flexion", &Posture::hip_flexion},
      {"knee-flexion", &Posture::knee_flexion},
      {"left-hip-flexion", &Posture::left_hip_flexion},
      {"right-hip-flexion", &Posture::right_hip_flexion},
      {"left-knee-flexion", &Posture::left_knee_flexion},
      {"right-knee-flexion", &Posture::right_knee_flexion},
      {"trunk-rotation", &Posture::trunk_rotation},
      {"side-bend", &Posture::side_bend},
  };
  return kOf.at(joint);
}

void turn(Posture& posture, const JointAngle& angle) {
  posture.*turned_by(angle.joint) = radians(angle.degrees);
  if (angle.joint == "elbow-flexion") posture.elbow_extension = 1;
}

/// The joint that a text begins with, followed by "-"; nullptr for none.
const JointMotion* joint_of(const std::string& text) {
  for (const JointMotion& motion : joint_motions())
    if (text.starts_with(motion.name + "-")) return &motion;
  return nullptr;
}

InvalidInput wrong(const std::string& found, const std::string& expected) {
  return {{"", 0, "posture"}, "\"" + printable(found) + "\"", expected, ""};
}

JointAngle read_angle(const std::string& text) {
  const JointMotion* motion = joint_of(text);
  if (!motion)
    throw wrong(text,
                "a joint with its angle in degrees, as in elbow-flexion-90; joints joined by +");
  const std::string expected =
      fmt::format("{}- and degrees from {:g} to {:g}", motion->name, motion->low, motion->high);
  const char* begin = text.data() + motion->name.size() + 1;
  const char* end = text.data() + text.size();
  JointAngle angle{motion->name, 0};
  const auto [rest, error] = std::from_chars(begin, end, angle.degrees, std::chars_format::fixed);
  if (error != std::errc() || rest != end || !(angle.degrees >= motion->low) ||
      !(angle.degrees <= motion->high))
    throw wrong(text, expected);
  return angle;
}

}  // namespace

const std::vector<JointMotion>& joint_motions() {
  static const std::vector<JointMotion> kAll = {
      {"elbow-flexion", 0, 130, "forearm to the upper arm"},
      {"shoulder-flexion", -40, 170, "arms forward and up"},
      {"shoulder-abduction", 5, 110, "arms aside and up"},
      {"wrist-flexion", -70, 80, "hand to the palm"},
      {"hip-flexion", -15, 100, "thighs forward"},
      {"knee-flexion", 0, 120, "heels back"},
      {"left-hip-flexion", -15, 100, "the left thigh forward"},
      {"right-hip-flexion", -15, 100, "the right thigh forward"},
      {"left-knee-flexion", 0, 120, "the left heel back"},
      {"right-knee-flexion", 0, 120, "the right heel back"},
      {"trunk-rotation", -45, 45, "shoulders to the wearer's left"},
      {"side-bend", -35, 35, "to the wearer's left"},
  };
  return kAll;
}

std::string joint_posture_name(const std::vector<JointAngle>& angles) {
  std::string name;
  for (const JointAngle& angle : angles)
    name += (name.empty() ? "" : "+") + angle.joint + "-" +
            shortest(std::round(10 * angle.degrees) / 10 + 0.0);
  return name;
}

std::optional<std::vector<JointAngle>> joint_angles(const std::string& name) {
  if (!joint_of(name)) return std::nullopt;
  std::vector<JointAngle> angles;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('+', begin), name.size());
    angles.push_back(read_angle(name.substr(begin, end - begin)));
    if (std::count_if(angles.begin(), angles.end(), [&](const JointAngle& other) {
          return other.joint == angles.back().joint;
        }) > 1)
      throw wrong(name, "each joint once");
    begin = end + 1;
  }
  return angles;
}

Posture joint_posture(const std::vector<JointAngle>& angles, const Posture& from) {
  Posture posture = from;
  for (const JointAngle& angle : angles) turn(posture, angle);
  return posture;
}

std::string joint_posture_pattern() {
  std::vector<std::string> names;
  for (const JointMotion& motion : joint_motions()) names.push_back(motion.name);
  std::string any;
  for (const std::string& name : names) any += (any.empty() ? "" : "|") + name;
  const std::string one = "(" + any + ")-(-?[0-9]+(\\.[0-9]+)?)";
  return one + "(\\+" + one + ")*";
}

}  // namespace loosefit::body
