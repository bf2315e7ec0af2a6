#pragma once
#include "loosefit/drape/cloth_state.h"

namespace loosefit::drape {

/// Settles the finest level from anywhere near to the last digits. Contact is refined near the skin
/// when the level begins and on the way down (drape/refine_contact.h), long before the last digits
/// are sought; at rest triangles that still cut the skin are freed round after round
/// (RecoveryKind::free_cuts). Keeps the best states it comes by.
void free_penetrations(ClothState& state);

/// The last part of it, from near rest: `first_dt` is the first pseudo-step [s].
void settle_without_penetrations(ClothState& state, double first_dt);

/// Whether triangles cut the skin, by the exact test; they are state.penetrating. A state without
/// any is kept when it is the best one yet.
bool find_penetrations(ClothState& state);

/// Gives the triangles in state.penetrating more contact points where the skin reaches into them;
/// after PenetrationTuning::exact_rounds also holds them off (drape/raise_offsets.h). The cloth has
/// to be settled again.
void free_cuts(ClothState& state);

}  // namespace loosefit::drape
