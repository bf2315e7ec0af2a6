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

/// Where a path ends.
struct PathEnd {
  /// The cloth settles there; otherwise the body goes on at once, and a rougher field of distances
  /// does on the coarsest level.
  bool stays = true;
  /// The body there with a field that is at hand; null: made anew.
  std::shared_ptr<const ContactBody> known = nullptr;
};

/// The same along any path that begins where the body stands; also of a body that does not turn.
void follow_path(ClothState& state, const body::BodyPath& path, const PathEnd& end);

/// Largest rotation that any skin undergoes from one posture to another [rad].
double largest_turn(const body::Body& from, const body::Body& to, const FollowTuning& tuning);

/// How deep the deepest point lies in the skin [m].
double depth_in_skin(const std::vector<Vec3>& x, const body::PosedBody& body);

}  // namespace loosefit::drape
