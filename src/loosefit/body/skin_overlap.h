#pragma once
#include "loosefit/body/body.h"

namespace loosefit {

/// Parts skin of arm and trunk that the posture has pushed into each other, as at the armpits of
/// arms that hang close: flesh gives way on both sides alike, until kSkinGap lies between them,
/// room for a sleeve and a side panel. Where nothing overlaps the body is left as it is, bit for
/// bit. The displacement joins body.pose_from_rest, so that both still tell the same place. `rest`:
/// the vertices of the surface before posing. Returns how far the skin was pressed in at most [m].
double part_overlapping_skin(Body& body, const std::vector<Vec3>& rest);

inline constexpr double kSkinGap = 0.008;  ///< between skins that were parted [m]

}  // namespace loosefit
