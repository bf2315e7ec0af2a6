#pragma once
#include "loosefit/drape/cloth_state.h"

namespace loosefit::drape {

/// Settles the finest level from anywhere near to the last digits. Triangles that cut the skin, or
/// are about to, are looked for on the way down already, long before the last digits are sought;
/// at rest their contact offsets are raised round after round (RecoveryKind::raise_offsets) until
/// nothing cuts. Keeps the best states it comes by.
void free_penetrations(ClothState& state);

/// The last part of it, from near rest: `first_dt` is the first pseudo-step [s].
void settle_without_penetrations(ClothState& state, double first_dt);

/// Whether triangles cut the skin, by the exact test; they are state.penetrating. A state without
/// any is kept when it is the best one yet.
bool find_penetrations(ClothState& state);

/// Raises the contact offsets of state.penetrating, and of triangles that are about to cut
/// (drape/raise_offsets.h); state.offsets_raised tells whether any was raised, so that the cloth
/// has to be settled again.
void raise_offsets(ClothState& state);

}  // namespace loosefit::drape
