#pragma once
#include "loosefit/drape/cloth_state.h"

namespace loosefit::drape {

/// Lays the garments round the body at the beginning of state.path; where they find no room, round
/// that of state.wide_path, which then is the path (RecoveryKind::wide_posture). Then shifts the
/// start a little where the options ask for it, and gives the body its field.
/// \throws NoRoom when they find room in neither; GeometryError for a garment or a body that is not
/// fit for it.
void dress_on(ClothState& state);

/// Tries it; what was in the way is in state.no_room.
void lay_round_body(ClothState& state);

}  // namespace loosefit::drape
