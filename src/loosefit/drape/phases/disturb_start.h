#pragma once
#include "loosefit/drape/cloth_state.h"

namespace loosefit::drape {

/// Shifts the garment and twists it on the trunk as the options ask (DrapeOptions::start_shift,
/// start_twist), in steps that are each settled loosely: one donning of many.
void disturb_start(ClothState& state);

}  // namespace loosefit::drape
