#include "loosefit/drape/phases/smooth_out.h"

#include "loosefit/drape/phases/certify_state.h"
#include "loosefit/drape/phases/free_penetrations.h"
#include "loosefit/drape/smooth_cuts.h"

namespace loosefit::drape {

void smooth_out(ClothState& state) {
  const CertifyTuning& tuning = state.tuning.certify;
  // Farther off the skin each time.
  const double clear = tuning.smoothed_clear * state.attempts[RecoveryKind::smooth_cuts];
  state.x = smooth_cuts(std::move(state.x), state.triangles(), state.body->body.tree(), clear,
                        tuning.smoothing_rounds, SmoothedFaults::all)
                .x;
  settle_without_penetrations(state, state.tuning.penetrations.first_dt);
  state.attempts[RecoveryKind::nearer_to_rest] = 0;
  measure_certificate(state);
}

}  // namespace loosefit::drape
