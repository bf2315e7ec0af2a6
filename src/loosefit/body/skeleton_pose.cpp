#include "loosefit/body/skeleton_pose.h"

#include <cmath>

#include "loosefit/geometry/rotation_between.h"

namespace loosefit::body {
namespace {

// Shares of the arm angle and of the bend, lowest spine bone first.
constexpr double kClavicleShare = 0.15, kShoulderShare = 0.10, kUpperArmShare = 0.75;
constexpr double kSpineShare[5] = {0.3, 0.3, 0.2, 0.1, 0.1};
constexpr double kClavicleTurn = 0.15, kClavicleLift = 0.10, kBladeTurn = 0.10;  // of arm flexion
// Of a full slouch, lowest spine bone first [rad].
constexpr double kSlouchSpine[5] = {radians(4), radians(6), radians(8), radians(7), radians(5)};
constexpr double kSlouchShoulder = radians(10), kSlouchNeck = radians(8),
                 kSlouchHead = radians(-25);
// Shares of the turn and of the bend to the side, lowest spine bone first: the chest turns more
// than the loins, which bend more.
constexpr double kSpineTurn[5] = {0.10, 0.15, 0.20, 0.30, 0.25};
constexpr double kSpineSide[5] = {0.25, 0.25, 0.20, 0.15, 0.15};
// Measured: bones turning by b together turn the line C7 - back waist by b / 1.09 for 10° … 60°.
constexpr double kBendGain = 1.09;

// Twists of the two halves of the upper arm, and of the two halves of the forearm and the hand: the
// skin turns evenly from the shoulder to the elbow, and from there to the wrist.
constexpr double kHumerusTwist = 0.5, kForearmTwist[3] = {0.25, 0.5, 0.25};

Mat3 about(const Vec3& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

Vec3 joint_of(const BodyData& data, const std::vector<Vec3>& joints, const std::string& bone) {
  return joints[std::size_t(data.bones[std::size_t(data.bone(bone))].head)];
}

/// Angle about `axis` (unit) that brings `from` into the half plane of axis and `to`.
double turn_about(const Vec3& axis, const Vec3& from, const Vec3& to) {
  const Vec3 a = from - axis * axis.dot(from), b = to - axis * axis.dot(to);
  return std::atan2(axis.dot(a.cross(b)), a.dot(b));
}

Mat3& rotation_of(BoneRotations& rotations, const std::string& bone) {
  return rotations.try_emplace(bone, Mat3::Identity()).first->second;
}

/// Turn of the forearm about the elbow: a share of what brings it into line with the upper arm,
/// less `flexion` [rad] about the same axis.
Mat3 elbow_turn(const BodyData& data, const std::vector<Vec3>& joints, const std::string& side,
                double share, double flexion) {
  const Vec3 elbow = joint_of(data, joints, "lowerarm01" + side);
  const Vec3 upper = elbow - joint_of(data, joints, "upperarm01" + side),
             fore = joint_of(data, joints, "wrist" + side) - elbow;
  const Eigen::AngleAxisd whole(geometry::rotation_between(fore, upper));
  return about(whole.axis(), share * whole.angle() - flexion);
}

/// Turns upper arms and forearms about their own length after what the bones do already: the elbow
/// bends to where `forward` points (of an arm that is not raised: −y), and there points the thumb
/// of an arm that is not bent; `extension` as in elbow_turn. Bending turns the thumb with the
/// forearm.
void relax_arms(const BodyData& data, const std::vector<Vec3>& joints, double share,
                const Vec3& forward, double extension, BoneRotations& rotations) {
  for (const std::string side : {".L", ".R"}) {
    const auto head = [&](const char* bone) { return joint_of(data, joints, bone + side); };
    const Vec3 elbow = head("lowerarm01");
    const Vec3 upper = (elbow - head("upperarm01")).normalized();
    const Vec3 fore = (head("wrist") - elbow).normalized();
    const Vec3 thumbward = head("finger2-1") - head("finger5-1");
    const Mat3 arm = rotation_of(rotations, "clavicle" + side) *
                     rotation_of(rotations, "shoulder01" + side) *
                     rotation_of(rotations, "upperarm01" + side);
    // In the frame of the rest posture, in which the bones' own rotations are told.
    const Vec3 ahead = arm.transpose() * forward;
    const double humerus = turn_about(upper, fore, ahead);
    const auto twist = [&](const std::string& bone, const Vec3& axis, double angle) {
      Mat3& rotation = rotation_of(rotations, bone + side);
      rotation = rotation * about(axis, share * angle);
    };
    twist("upperarm01", upper, kHumerusTwist * humerus);
    twist("upperarm02", upper, (1 - kHumerusTwist) * humerus);
    // Palm, after the whole turn of the upper arm. Not after the bend of the elbow: a forearm that
    // points forward has no side that does.
    const Mat3 stretched = elbow_turn(data, joints, side, extension, 0);
    const Vec3 ahead_of_elbow = (about(upper, humerus) * stretched).transpose() * ahead;
    const double radius = turn_about(fore, thumbward, ahead_of_elbow);
    twist("lowerarm01", fore, kForearmTwist[0] * radius);
    twist("lowerarm02", fore, kForearmTwist[1] * radius);
    twist("wrist", fore, kForearmTwist[2] * radius);
  }
}

/// Turns the hands towards the palm, about the line across the knuckles that is square to the
/// forearm, before whatever else turns the hand.
void flex_wrists(const BodyData& data, const std::vector<Vec3>& joints, double angle,
                 BoneRotations& rotations) {
  for (const auto& [side, sign] : {std::pair(".L", -1.0), std::pair(".R", 1.0)}) {
    const auto head = [&](const char* bone) {
      return joint_of(data, joints, bone + std::string(side));
    };
    const Vec3 fore = (head("wrist") - head("lowerarm01")).normalized();
    const Vec3 thumbward = head("finger2-1") - head("finger5-1");
    const Vec3 axis = (thumbward - fore * fore.dot(thumbward)).normalized();
    Mat3& hand = rotation_of(rotations, std::string("wrist") + side);
    hand = hand * about(axis, sign * angle);
  }
}

/// Raises the arms forward by `angle` after what the bones do already.
void raise_forward(double angle, BoneRotations& rotations) {
  for (const auto& [side, sign] : {std::pair(".L", 1.0), std::pair(".R", -1.0)}) {
    Mat3 &clavicle = rotations[std::string("clavicle") + side],
         &blade = rotations[std::string("shoulder01") + side],
         &upper = rotations[std::string("upperarm01") + side];
    const Mat3 target = about(Vec3::UnitX(), -angle) * clavicle * blade * upper;
    clavicle = about(-Vec3::UnitY(), sign * kClavicleLift * angle) *
               about(Vec3::UnitX(), -kClavicleTurn * angle) * clavicle;
    blade = about(Vec3::UnitX(), -kBladeTurn * angle) * blade;
    upper = (clavicle * blade).transpose() * target;
  }
}

void slump(double share, BoneRotations& rotations) {
  for (int i = 0; i < 5; ++i) {
    Mat3& bone = rotations["spine0" + std::to_string(5 - i)];
    bone = about(Vec3::UnitX(), share * kSlouchSpine[i]) * bone;
  }
  rotations["neck01"] = about(Vec3::UnitX(), share * kSlouchNeck);
  rotations["head"] = about(Vec3::UnitX(), share * kSlouchHead);
  for (const auto& [side, sign] : {std::pair(".L", 1.0), std::pair(".R", -1.0)}) {
    Mat3& clavicle = rotations[std::string("clavicle") + side];
    clavicle = about(Vec3::UnitZ(), -sign * share * kSlouchShoulder) * clavicle;
  }
}

}  // namespace

double rest_arm_abduction(const BodyData& data, const std::vector<Vec3>& joints) {
  const Bone& upper = data.bones[std::size_t(data.bone("upperarm01.L"))];
  const Bone& lower = data.bones[std::size_t(data.bone("lowerarm01.L"))];
  const Vec3 arm = joints[std::size_t(lower.head)] - joints[std::size_t(upper.head)];
  return std::atan2(arm.x(), -arm.z());
}

BoneRotations posture_rotations(const BodyData& data, const std::vector<Vec3>& joints,
                                const Posture& posture) {
  return posture_rotations(data, joints, posture, {posture.arm_abduction, posture.arm_abduction});
}

BoneRotations posture_rotations(const BodyData& data, const std::vector<Vec3>& joints,
                                const Posture& posture, const ArmsAside& arms) {
  BoneRotations rotations;
  const double at_rest = rest_arm_abduction(data, joints);
  const auto raise = [&](const std::string& bone, double share) {
    // About -y (forward) a positive angle raises the left arm; the right arm mirrors it.
    rotations[bone + ".L"] = about(-Vec3::UnitY(), share * (arms.left - at_rest));
    rotations[bone + ".R"] = about(-Vec3::UnitY(), -share * (arms.right - at_rest));
  };
  raise("clavicle", kClavicleShare);
  raise("shoulder01", kShoulderShare);
  raise("upperarm01", kUpperArmShare);

  if (posture.arm_flexion != 0) raise_forward(posture.arm_flexion, rotations);
  if (posture.elbow_extension != 0 || posture.elbow_flexion != 0)
    for (const char* side : {".L", ".R"})
      rotations[std::string("lowerarm01") + side] =
          elbow_turn(data, joints, side, posture.elbow_extension, posture.elbow_flexion);
  if (posture.relaxed_arms != 0)
    relax_arms(data, joints, posture.relaxed_arms,
               about(Vec3::UnitX(), -posture.arm_flexion) * -Vec3::UnitY(), posture.elbow_extension,
               rotations);

  if (posture.wrist_flexion != 0) flex_wrists(data, joints, posture.wrist_flexion, rotations);

  for (int i = 0; i < 5; ++i) {
    Mat3& bone = rotations["spine0" + std::to_string(5 - i)];
    bone = about(Vec3::UnitX(), kSpineShare[i] * kBendGain * posture.forward_bend);
    if (posture.side_bend != 0)
      bone = about(Vec3::UnitY(), kSpineSide[i] * posture.side_bend) * bone;
    if (posture.trunk_rotation != 0)
      bone = about(Vec3::UnitZ(), kSpineTurn[i] * posture.trunk_rotation) * bone;
  }
  if (posture.slouch != 0) slump(posture.slouch, rotations);
  const auto bend_leg = [&](const char* side, double hip, double knee) {
    rotations[std::string("upperleg01") + side] =
        about(Vec3::UnitX(), -posture.sitting * kPi / 2 - posture.hip_flexion - hip);
    rotations[std::string("lowerleg01") + side] =
        about(Vec3::UnitX(), posture.sitting * kPi / 2 + posture.knee_flexion + knee);
  };
  bend_leg(".L", posture.left_hip_flexion, posture.left_knee_flexion);
  bend_leg(".R", posture.right_hip_flexion, posture.right_knee_flexion);
  return rotations;
}

std::vector<Eigen::Affine3d> pose_bones(const BodyData& data, const std::vector<Vec3>& joints,
                                        const BoneRotations& rotations) {
  std::vector<Eigen::Affine3d> maps;
  maps.reserve(data.bones.size());
  for (const Bone& bone : data.bones) {
    Eigen::Affine3d map =
        bone.parent < 0 ? Eigen::Affine3d::Identity() : maps[std::size_t(bone.parent)];
    const auto turn = rotations.find(bone.name);
    if (turn != rotations.end()) {
      const Vec3& head = joints[std::size_t(bone.head)];
      const Eigen::Affine3d rotation(turn->second);
      map = map * Eigen::Translation3d(head) * rotation * Eigen::Translation3d(-head);
    }
    maps.push_back(map);
  }
  return maps;
}

std::vector<Eigen::Matrix<double, 3, 4>> blend_bones(
    const std::vector<Eigen::Affine3d>& bones,
    const std::vector<std::vector<std::pair<int, double>>>& skin) {
  std::vector<Eigen::Matrix<double, 3, 4>> maps;
  maps.reserve(skin.size());
  for (const auto& influences : skin) {
    Eigen::Matrix<double, 3, 4> map = Eigen::Matrix<double, 3, 4>::Zero();
    for (const auto& [bone, weight] : influences) {
      map += weight * bones[std::size_t(bone)].matrix().topRows<3>();
    }
    maps.push_back(map);
  }
  return maps;
}

}  // namespace loosefit::body
