#include "loosefit/drape/phases/smooth_out.h"

#include <utility>

#include "loosefit/drape/phases/certify_state.h"
#include "loosefit/drape/phases/free_penetrations.h"
#include "loosefit/drape/smooth_cuts.h"

namespace loosefit::drape {
namespace {

int cuts_of(const Certificate& c) { return c.intersections_body + c.intersections_self; }

}  // namespace

void smooth_out(ClothState& state) {
  const CertifyTuning& tuning = state.tuning.certify;
  const Certificate before = state.certificate;
  const auto outcome = state.last;
  std::optional<ClothState::Kept> kept;
  state.keep(kept, before.residual);
  // From where the last attempt ended, farther off the skin each time: the way out may lead over
  // states that cut more.
  for (int attempt = 1; attempt <= tuning.smoothing_attempts && !state.is_over(); ++attempt) {
    state.x =
        smooth_cuts(std::move(state.x), state.triangles(), state.body->body.tree(),
                    attempt * tuning.smoothed_clear, tuning.smoothing_rounds, SmoothedFaults::all)
            .x;
    settle_without_penetrations(state, state.tuning.penetrations.first_dt);
    measure_certificate(state);
    if (cuts_of(state.certificate) == 0) break;
  }
  state.attempts[RecoveryKind::nearer_to_rest] = 0;
  if (cuts_of(state.certificate) < cuts_of(before)) return;
  go_back(state, *kept);
  state.last = outcome;
  measure_certificate(state);
}

}  // namespace loosefit::drape
