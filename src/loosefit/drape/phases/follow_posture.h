#pragma once
#include "loosefit/drape/cloth_state.h"

namespace loosefit::drape {

/// Takes the cloth along with the body from where that stands to the end of state.path, in steps
/// that are each settled to a loose tolerance: carried by the smoothed motion of the skin, parts of
/// the cloth that would meet moved as rigid zones. A step in which the cloth cannot go along is
/// halved (RecoveryKind::shorter_step), one after which the forces are far from balanced is settled
/// longer (settle_longer). When time or iterations are used up, ends on the wanted body all the
/// same.
void follow_posture(ClothState& state);

/// How the steps are made of this state: of one layer or several.
const StepPlan& step_plan(const ClothState& state);

/// Largest rotation that any skin undergoes from one posture to another [rad].
double largest_turn(const body::Body& from, const body::Body& to, const FollowTuning& tuning);

/// How deep the deepest point lies in the skin [m].
double depth_in_skin(const std::vector<Vec3>& x, const body::PosedBody& body);

}  // namespace loosefit::drape
