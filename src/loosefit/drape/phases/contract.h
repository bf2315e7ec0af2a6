#pragma once
#include "loosefit/drape/cloth_state.h"

namespace loosefit::drape {

/// The start is strained. It contracts as if it were soft at first, and without friction, so that
/// it comes to lie on the limbs and is not pulled through them. It has no weight until it is as
/// stiff and as rough as it is: a waistband that stretches over the hips would fall. Ends with the
/// cloth as it is, over a soft layer, at the coarsest level; a continuation in stiffness.
void contract_soft(ClothState& state);

/// With its own stiffness, friction and weight, to where it may move on.
void contract(ClothState& state);

}  // namespace loosefit::drape
