#pragma once
#include <vector>

#include "loosefit/garment/garment.h"
#include "loosefit/maps/skin_partner.h"

namespace loosefit::report {

/// How the cloth has slipped on the skin, as arrows for a picture.
struct SlipArrows {
  std::vector<Vec3> from, to;  ///< [m]; `to` lies on the cloth as it is now
};

/// Arrows at garment vertices that lie about `spacing` [m] apart in the flat pattern. An arrow
/// begins where the point of the cloth would be had it gone along with the skin under it, and is
/// maps::Slip in space: the tangential part of the change of its offset. Slips below `least` [m]
/// get none. \throws InvalidInput as maps::vertex_slips.
SlipArrows slip_arrows(const garment::Garment& garment, const maps::DressedState& reference,
                       const maps::DressedState& now, double spacing = 0.03, double least = 0.001);

}  // namespace loosefit::report
