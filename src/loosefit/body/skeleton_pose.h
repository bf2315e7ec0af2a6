#pragma once
#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/body/body_data.h"

namespace loosefit::body {

/// Rotation of bones by name, about world-aligned axes in the parent's moving frame.
using BoneRotations = std::map<std::string, Mat3>;

/// Angle of the left upper arm to the downward vertical in the frontal plane, rest posture [rad].
double rest_arm_abduction(const BodyData& data, const std::vector<Vec3>& joints);

/// Angle of each upper arm to the downward vertical [rad].
struct ArmsAside {
  double left = 0, right = 0;
};

/// Bone rotations of a posture: the arm angle is shared by clavicle, shoulder and upper arm, the
/// bend by the five spine bones (scaled so that the line from C7 to the back waist turns by it).
/// Raising the arms forward turns the clavicle about its own length by 15 % of the angle and lifts
/// it by 10 % (27° and 18° of 180°; Ludewig et al. 2009 measured about 30° and 10°, recalled), the
/// shoulder blade follows by 10 %, and the upper arm does what is left. A full slouch is ours: 30°
/// of spine flexion, most of it in the chest, shoulders drawn forward by 10°, the face lifted again
/// by 25°. The elbow flexes about the axis in which the rest posture bends it, the wrist about the
/// line across the knuckles; a turn of the trunk and a bend to the side are shared by the spine
/// bones in proportions of ours. Mirrored postures have mirrored rotations.
BoneRotations posture_rotations(const BodyData& data, const std::vector<Vec3>& joints,
                                const Posture& posture);
/// The same with each arm as far aside as told, whatever `arm_abduction` says.
BoneRotations posture_rotations(const BodyData& data, const std::vector<Vec3>& joints,
                                const Posture& posture, const ArmsAside& arms);

/// Rest → posed map of every bone: M(b) = M(parent) · T(head) · R · T(-head).
std::vector<Eigen::Affine3d> pose_bones(const BodyData& data, const std::vector<Vec3>& joints,
                                        const BoneRotations& rotations);

/// Linear blend skinning: the blended map of each vertex (Magnenat-Thalmann et al. 1988).
std::vector<Eigen::Matrix<double, 3, 4>> blend_bones(
    const std::vector<Eigen::Affine3d>& bones,
    const std::vector<std::vector<std::pair<int, double>>>& skin);

}  // namespace loosefit::body
