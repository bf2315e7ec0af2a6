#pragma once
#include <vector>

#include "loosefit/drape/openings.h"
#include "loosefit/garment/open_seams.h"

namespace loosefit::drape {

/// What part of a person a panel goes round.
enum class PanelRole {
  trunk,
  left_arm,
  right_arm,
  limb  ///< none of the others: its piece of cloth is worn on one limb by itself (limb_pieces.h)
};

/// Role of every panel of the garment. Labels ("arm") come first, then what the seams say: a panel
/// that reaches an arm's opening and no other one belongs to that arm, and so does what is sewn to
/// arms only; a name with "sleeve" tells where a sleeve reaches other openings, too (raglan). Sides
/// by where the pattern places the panel. Everything else, collars, hoods and legs included, goes
/// with the trunk. placed: vertices of open.garment [m].
std::vector<PanelRole> panel_roles(const garment::OpenSeams& open, const pattern::Pattern& pattern,
                                   const std::vector<Opening>& openings,
                                   const std::vector<Vec3>& placed);

}  // namespace loosefit::drape
