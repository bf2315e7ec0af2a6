#pragma once
#include "loosefit/body/body.h"
#include "loosefit/kinds/girth_line.h"

namespace loosefit::kinds {

/// Tape girths of a body at every kStationStep along its limbs (kinds/fit_stations.h), at round
/// multiples of it. Where a section would go round a second limb too, the line begins below or
/// ends above.
///
/// Trunk: level sections where a tape down the back is as long; above the level of the chest its
/// girth counts, since a level section there goes round the roots of the arms. Arm: sections square
/// to it, the one at the elbow halves its bend; the larger of both arms, or of those that a person
/// has whole. Leg: level sections, the larger of both legs.
/// \param open upright, the arms apart; its joints, landmarks and measures are read, and what of
/// them is missing leaves out the limb.
GirthsAlong girths_along(const body::Body& open);

}  // namespace loosefit::kinds
