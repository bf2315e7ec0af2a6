#pragma once
#include "loosefit/drape/cloth_state.h"

namespace loosefit::drape {

/// Leaves a balance of forces that is a saddle of the energy: the cloth goes a little way along the
/// mode of lowest curvature (solver/stability.h), to the side of lower energy and as far as it
/// meets nothing, settles from there, and is certified. The saddle stays in state.saddle.
void leave_saddle(ClothState& state);

}  // namespace loosefit::drape
