#pragma once
#include "loosefit/drape/cloth_state.h"

namespace loosefit::drape {

/// Another way to rest where the first one failed: the cloth is lifted off the skin by the soft
/// layer, its contacts and friction are forgotten, and it settles and is certified anew; where it
/// cuts, with a field that resolves folds of skin. What the first way led to stays in
/// state.first_try.
void lift_off_and_resettle(ClothState& state);

}  // namespace loosefit::drape
