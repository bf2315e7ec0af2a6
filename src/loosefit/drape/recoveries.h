#pragma once
#include "loosefit/drape/recovery.h"

namespace loosefit::drape {

/// All recoveries of a drape: what may fail on the way from dressed to certified, what is tried
/// then, and why. The phases go through this table (ClothState::recover) and know no others;
/// progress and SettleReport::recoveries name them by it. Rows of one point are tried in this
/// order.
///
/// Not in the table, since they stay within one module and never leave a trace in the drape:
/// * a start that cuts itself: other clearances, panels that are drawn outwards
/// more (dress/dress_layers.h, drape/phases/sew_on.h);
/// * a Newton matrix that is not definite, a step that does not descend, no descent at all: choice
///   of the matrix, line search and hinge tangent (solver/);
/// * friction that alternates: under-relaxation (contact/friction.h);
/// * poses in which skin would pass through itself (flesh/soft_skin.h).
const Recoveries& recoveries();

}  // namespace loosefit::drape
