#pragma once
#include <Eigen/Geometry>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "loosefit/body/rigid_motion.h"
#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::body {

/// Coarse body parts; one per surface vertex (docs/theory/body_model.md 1).
enum class Segment { head, neck, torso, upper_arm, forearm, hand, thigh, shank, foot };

/// How the person stands. Angles in radians.
struct Posture {
  double arm_abduction = 0.4363323129985824;  ///< upper arm to the downward vertical; 25°
  double forward_bend = 0;                    ///< change of back inclination
  double sitting = 0;                         ///< 0 standing … 1 hips and knees flexed 90°
  double arm_flexion = 0;      ///< the arms so abducted, raised forward against the trunk
  double elbow_extension = 0;  ///< share of the model's bent elbow (46°) that is straightened
  double slouch = 0;           ///< 0 upright … 1 slumped (skeleton_pose.h)
  /// 0 arms turned as the model has them … 1 hanging as people let them: elbows bend forward, palms
  /// face the thighs (skeleton_pose.h), and arms that find no room beside the trunk hang as far
  /// aside as they need (hanging_arms.h).
  double relaxed_arms = 0;
  // Joints by themselves, both sides alike; 0: as the rest of the posture has them.
  double elbow_flexion = 0;   ///< beyond what elbow_extension leaves
  double wrist_flexion = 0;   ///< hand towards the palm; negative: extension
  double hip_flexion = 0;     ///< thighs forward, beyond `sitting`
  double knee_flexion = 0;    ///< shanks back, beyond `sitting`
  double trunk_rotation = 0;  ///< shoulders against pelvis, to the wearer's left
  double side_bend = 0;       ///< to the wearer's left
  // Of one leg, beyond what both do.
  double left_hip_flexion = 0, right_hip_flexion = 0;
  double left_knee_flexion = 0, right_knee_flexion = 0;
  bool operator==(const Posture&) const = default;
};

/// A closed body surface in one posture, z up, facing -y, +x the wearer's left, floor at z = 0.
struct Body {
  geometry::TriangleMesh surface;  ///< closed, outward oriented [m]
  std::vector<Vec3> normals;       ///< smooth unit normal per surface vertex
  std::vector<Segment> segment;    ///< per surface vertex
  std::vector<int> side;           ///< per vertex: +1 wearer's left, -1 right, 0 trunk/head
  std::map<std::string, Vec3>
      joints;  ///< "shoulder_L", "elbow_L", "wrist_L", "neck", "hip_L", … [m]
  std::map<std::string, Vec3> landmarks;  ///< "c7", "acromion_L", "back_waist", "scapula_L", … [m]
  std::map<std::string, int> landmark_vertex;  ///< the same as surface vertex indices
  /// Measured on this surface in rest posture [m] (slopes in rad): height, chest, underbust, waist,
  /// hip, neck, upper_arm, wrist, shoulder_breadth, shoulder_slope, scye_depth (shoulder point to
  /// armpit, vertical), hps_to_waist, hps_to_hip, hps_to_crown, arm_length, …
  std::map<std::string, double> measured;
  /// Rest → posed affine map of each surface vertex (linear blend skinning); empty for scans.
  std::vector<Eigen::Matrix<double, 3, 4>> pose_from_rest;
  /// The world of a scan's file (in metres, z up; a file with y up turned by (x, −z, y)) → this
  /// frame: turns about z and a shift. Nothing for people from measures.
  RigidMotion from_world = RigidMotion::Identity();
};

/// All that a posture is made of.
inline constexpr double Posture::*kPostureNumbers[] = {
    &Posture::arm_abduction,     &Posture::forward_bend,      &Posture::sitting,
    &Posture::arm_flexion,       &Posture::elbow_extension,   &Posture::slouch,
    &Posture::relaxed_arms,      &Posture::elbow_flexion,     &Posture::wrist_flexion,
    &Posture::hip_flexion,       &Posture::knee_flexion,      &Posture::trunk_rotation,
    &Posture::side_bend,         &Posture::left_hip_flexion,  &Posture::right_hip_flexion,
    &Posture::left_knee_flexion, &Posture::right_knee_flexion};
static_assert(sizeof(Posture) == std::size(kPostureNumbers) * sizeof(double));

/// Linear blend of two postures: share 0 gives `from`, 1 gives `to`.
inline Posture blend(const Posture& from, const Posture& to, double share) {
  Posture posture;
  for (double Posture::*number : kPostureNumbers)
    posture.*number = from.*number + share * (to.*number - from.*number);
  return posture;
}

/// As people stand: the named posture "standing". Upper arms 8° aside, elbows bent by about 15° (a
/// third of the model's bend).
inline constexpr Posture kStanding{radians(8.0), 0, 0, 0, 0.66, 0, 1};

/// Upright with room for a garment under the arms: the named posture "a-pose".
inline constexpr Posture kArmsApart{radians(40.0), 0, 0};

/// The arms farther apart: for garments that find no room in a-pose.
inline constexpr Posture kArmsWide{radians(55.0), 0, 0};

/// Arms between these are apart as a garment needs them to be put on.
inline constexpr double kLeastOpen = radians(35.0), kMostOpen = radians(60.0);

/// Where a garment is put on when nothing is said: in the wanted posture itself if the arms are
/// apart and the person is upright, otherwise with the arms apart; they are then lowered.
inline Posture default_dress_posture(const Posture& wanted) {
  const bool open = wanted.arm_abduction >= kLeastOpen && wanted.arm_abduction <= kMostOpen;
  const bool upright = wanted.forward_bend == 0 && wanted.sitting == 0 && wanted.arm_flexion == 0 &&
                       wanted.slouch == 0 && wanted.hip_flexion == 0 &&
                       wanted.left_hip_flexion == 0 && wanted.right_hip_flexion == 0 &&
                       wanted.trunk_rotation == 0 && wanted.side_bend == 0;
  return open && upright ? wanted : kArmsApart;
}

}  // namespace loosefit::body
