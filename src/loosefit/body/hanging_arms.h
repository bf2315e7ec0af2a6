#pragma once
#include <utility>
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/body/body_data.h"
#include "loosefit/body/rest_body.h"

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

/// The posture with its arms as far aside as they need to keep kRoomBesideTrunk beyond kArmpitShare
/// of the upper arm; as they are where they have it, and in proportion to `relaxed_arms`. Stout
/// people hold their arms farther aside. Room is measured sideways, at equal depth and height,
/// against the skin of trunk and thighs; an arm that finds none within 60° stays as asked.
Posture with_clear_arms(const BodyData& data, const RestBody& rest, const BodySkin& skin,
                        const Posture& posture);

}  // namespace loosefit::body
