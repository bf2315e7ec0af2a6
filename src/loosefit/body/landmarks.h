#pragma once
#include <map>
#include <string>
#include <vector>

#include "loosefit/body/rest_body.h"

namespace loosefit::body {

/// Vertex indices of the landmarks of the parametric body (docs/theory/body_model.md 3.4); pairs
/// end in _L, _R. The suggested sensor places are geometric choices, not clinical landmarks.
std::map<std::string, int> landmark_vertices(const BodyData& data, const RestBody& rest);

/// Joint name → joint of the data: "shoulder_L", "elbow_L", "wrist_L", "hand_L", "hip_L", "knee_L",
/// "ankle_L", "clavicle_L", "neck", "head", "pelvis", "spine_1" (uppermost) … "spine_5".
std::map<std::string, int> joint_indices(const BodyData& data);

/// Mid-sagittal back line from the hair line over C7 to the sacrum, vertex indices downwards.
const std::vector<int>& back_line();

}  // namespace loosefit::body
