#pragma once
#include <string>
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/garment/garment.h"
#include "loosefit/pattern/pattern.h"

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
  /// A tube with two ends, of which nothing but heights tells what is up, is by a quarter wider at
  /// its upper end than at its lower one: a skirt whose file shows it from its hem.
  std::string upside_down;
};
/// Nothing is said of a body without joints.
WayRound way_round(const garment::Garment& garment, const pattern::Pattern& pattern,
                   const std::vector<Vec3>& x, const body::PosedBody& body);

}  // namespace loosefit::drape
