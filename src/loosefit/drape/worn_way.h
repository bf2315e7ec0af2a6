#pragma once
#include <string>
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/garment/garment.h"

namespace loosefit::drape {

/// Which way round a garment at x [m] is worn by `body`, as sentences; empty where that is the
/// usual way. A garment that is worn so is worn all the same: left and right of its sites are those
/// of the wearer, not of the tailor.
struct WayRound {
  /// More of the outside of its cloth faces the wearer than looks away.
  std::string inside_out;
  /// The middle of its pieces for the front, as their names say, lies more than 60° beside that of
  /// the wearer, as seen from the middle of the pieces for the back.
  std::string turned;
};
/// Nothing is said of a body without joints.
WayRound way_round(const garment::Garment& garment, const std::vector<Vec3>& x,
                   const body::PosedBody& body);

}  // namespace loosefit::drape
