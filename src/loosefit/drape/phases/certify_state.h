#pragma once
#include "loosefit/drape/cloth_state.h"

namespace loosefit::drape {

/// Puts the certificate of the finest level as it is into state.certificate, then goes through the
/// recoveries of what it lacks (RecoveryPoint::certified), until it lacks nothing or none is left.
void certify_state(ClothState& state);

/// Certifies the finest level as it is.
void measure_certificate(ClothState& state);

/// Settles a little nearer to rest and certifies that. A certificate refreshes contacts, some of
/// which may come or go: then the residual is above what settling had reached.
void settle_nearer(ClothState& state);

/// Goes back to a kept state, with all of its friction. The model is one of the finest level.
void go_back(ClothState& state, const ClothState::Kept& kept);

/// Goes back to the best state that was kept, when it is better than the present one: without
/// penetrations before with them, then by the residual. Certifies it.
void take_best_state(ClothState& state);

/// The drape as the certificate found it, with forces, report and, when it is not settled, why.
Drape make_drape(ClothState& state);

}  // namespace loosefit::drape
