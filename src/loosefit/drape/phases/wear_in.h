#pragma once
#include "loosefit/drape/cloth_state.h"

namespace loosefit::drape {

/// Goes through state.movements on the level at hand, the coarsest: the cloth is carried along and
/// rubs as in follow_posture, hems are pulled and let go. At rest cloth is held by friction in one
/// of many places; the movements take it from the one where putting on has left it to one that
/// wearers know. Fidgeting is what comes after all others: the levels settle under it until the
/// cloth lies nearly still (ClothState::loosen_friction). What comes after begins on the very body
/// that stood there before, without any load; the cloth remembers by where it lies and sticks.
void wear_in(ClothState& state);

/// Forces of a pull on the hems of all layers that hang on the shoulders, so many times the weight
/// of each [–], evenly over its hem and down along the trunk [N]. Zero for all others.
particles::VectorField hem_pull(const ClothState& state, double weights);

}  // namespace loosefit::drape
