#pragma once
#include <utility>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/body/body_data.h"
#include "loosefit/body/rest_body.h"
#include "loosefit/body/skeleton_pose.h"

namespace loosefit::body {

/// Least room between a hanging arm and trunk or thigh, measured sideways [m]: for a sleeve and the
/// garment's side, each with a fold.
inline constexpr double kRoomBesideTrunk = 0.010;

/// Share of the upper arm, from the shoulder, that may lie on the side of the chest when the arm
/// hangs: it keeps no room, flesh gives way there.
inline constexpr double kArmpitShare = 0.8;

/// How the surface of a RestBody hangs on the bones, per vertex.
struct BodySkin {
  const std::vector<std::vector<std::pair<int, double>>>& weights;  ///< (bone, weight), sum 1
  const std::vector<Segment>& segment;
  const std::vector<int>& side;  ///< as Body::side
};

/// How far aside each arm of the posture hangs so that it keeps kRoomBesideTrunk beyond
/// kArmpitShare of the upper arm: as asked where it has that room, and in proportion to
/// `relaxed_arms`. Each arm is looked at by itself, the right one in the mirror: mirrored postures
/// have mirrored arms. Stout people hold their arms farther aside. Room is measured sideways, at
/// equal depth and height, against the skin of trunk and thighs; an arm that finds none within 60°
/// stays as asked.
ArmsAside clear_arms(const BodyData& data, const RestBody& rest, const BodySkin& skin,
                     const Posture& posture);

}  // namespace loosefit::body
