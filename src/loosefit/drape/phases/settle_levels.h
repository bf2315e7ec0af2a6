#pragma once
#include "loosefit/drape/cloth_state.h"

namespace loosefit::drape {

/// Settles each coarse level and hands it to the next finer one (prolongation) until the finest is
/// there, not settled yet. Keeps in state.handed_on how each was handed on.
void settle_coarse_levels(ClothState& state);

/// The same on the way to another posture. Instead of being smoothed, the finer level gets back
/// what set it apart from the coarser one in the worn state, as far as it meets nothing, and its
/// friction: what its contacts have slid on the moving skin since then. The coarse levels show how
/// deep cloth lies in the skin at worst [m].
double settle_coarse_levels_as_worn(ClothState& state);

}  // namespace loosefit::drape
