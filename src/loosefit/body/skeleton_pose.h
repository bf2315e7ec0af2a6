#pragma once
#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/body/body_data.h"

namespace loosefit {

/// Rotation of bones by name, about world-aligned axes in the parent's moving frame.
using BoneRotations = std::map<std::string, Mat3>;

/// Angle of the left upper arm to the downward vertical in the frontal plane, rest posture [rad].
double rest_arm_abduction(const BodyData& data, const std::vector<Vec3>& joints);

/// Bone rotations of a posture: the arm angle is shared by clavicle, shoulder and upper arm, the
/// bend by the five spine bones (scaled so that the line from C7 to the back waist turns by it).
BoneRotations posture_rotations(const BodyData& data, const std::vector<Vec3>& joints,
                                const Posture& posture);

/// Rest → posed map of every bone: M(b) = M(parent) · T(head) · R · T(-head).
std::vector<Eigen::Affine3d> pose_bones(const BodyData& data, const std::vector<Vec3>& joints,
                                        const BoneRotations& rotations);

/// Linear blend skinning: the blended map of each vertex (Magnenat-Thalmann et al. 1988).
std::vector<Eigen::Matrix<double, 3, 4>> blend_bones(
    const std::vector<Eigen::Affine3d>& bones,
    const std::vector<std::vector<std::pair<int, double>>>& skin);

}  // namespace loosefit
