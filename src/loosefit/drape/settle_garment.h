#pragma once
#include "loosefit/drape/cloth_state.h"

namespace loosefit::drape {

/// The whole way from dressed to certified: dresses the garments at the beginning of `path`, or of
/// `wide_path` where they find no room there, and settles them at its end. `worn` becomes what
/// follow_wearer needs. Does not throw when it fails to settle. \throws as dress_on; Cancelled
Drape dress_and_settle(ClothState& state, const body::BodyPath& path,
                       const body::BodyPath& wide_path, std::shared_ptr<const WornCloth>& worn);

/// Puts the garments of a drape that has not settled on once more, from a start that is shifted a
/// little, and certifies the better of both; the first, where the second cannot be put on or does
/// not come to rest. Time and iterations are those that the first left (ClothState::budget).
/// \throws Cancelled
void put_on_again(ClothState& state);

/// Takes garments from where dress_and_settle left them (`worn`) to the end of `path`, and settles
/// them there. \throws Cancelled
Drape follow_wearer(ClothState& state, const body::BodyPath& path,
                    std::shared_ptr<const WornCloth> worn);

}  // namespace loosefit::drape
