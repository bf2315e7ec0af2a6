#include "loosefit/drape/phases/free_penetrations.h"

#include <algorithm>

#include "loosefit/drape/raise_offsets.h"
#include "loosefit/drape/refine_contact.h"

namespace loosefit::drape {

namespace {

/// `cut`: triangles that still cut the skin at rest.
void see_skin(ClothState& state, const std::set<int>& cut = {}) {
  refine_contact(*state.model, *state.body, state.x, cut, state.tuning.penetrations);
}

/// Penetrations are looked for long before the last digits of the balance are sought.
void look_on_the_way(ClothState& state) {
  const PenetrationTuning& tuning = state.tuning.penetrations;
  for (std::size_t i = 0; i < tuning.look_tolerances.size(); ++i) {
    // Cloth as worn has its points and lies at rest already: softer, it would sink and slide.
    state.model->set_hardening(state.is_as_worn() ? 1 : tuning.look_hardening[i]);
    state.settle(
        {.tolerance = std::max(tuning.look_tolerances[i], state.options.residual_tolerance),
         .max_iterations = tuning.look_iterations,
         .first_dt = tuning.look_first_dt[i]});
    if (state.is_over()) break;
    find_penetrations(state);
    see_skin(state);
  }
  state.model->set_hardening(1);
}

}  // namespace

bool find_penetrations(ClothState& state) {
  state.penetrating = penetrating_triangles(state.model->mesh(), state.body->body, state.x);
  const bool low = !state.clear || state.last.residual < state.clear->residual;
  if (low && state.penetrating.empty()) state.keep(state.clear, state.last.residual);
  return !state.penetrating.empty();
}

void free_cuts(ClothState& state) {
  const PenetrationTuning& tuning = state.tuning.penetrations;
  if (state.attempts[RecoveryKind::free_cuts] <= tuning.exact_rounds)
    return see_skin(state, state.penetrating);
  raise_offsets_at_penetrations(*state.model, *state.body, state.x, state.penetrating,
                                state.times_cut, tuning);
  state.report.held_off_triangles = static_cast<int>(state.times_cut.size());
}

void free_penetrations(ClothState& state) {
  const PenetrationTuning& tuning = state.tuning.penetrations;
  state.times_cut.clear();
  state.lowest.reset(), state.clear.reset(), state.saddle.reset();
  state.attempts[RecoveryKind::free_cuts] = 0;
  state.report.held_off_triangles = 0;
  state.soften_contact(false);  // nothing is held off yet
  see_skin(state);
  state.loosen_friction();
  look_on_the_way(state);
  if (state.is_over()) return;
  state.stick();
  settle_without_penetrations(state, tuning.first_dt);
}

void settle_without_penetrations(ClothState& state, double first_dt) {
  const PenetrationTuning& tuning = state.tuning.penetrations;
  const double wanted = state.options.residual_tolerance;
  const auto freed = [&] { return state.recover(RecoveryPoint::at_rest); };
  // A round for the last digits, while there are still penetrations, would be thrown away.
  for (;; first_dt = tuning.near_rest_dt) {
    state.settle({.tolerance = std::max(tuning.tolerance, wanted),
                  .max_iterations = kNoLimit,
                  .first_dt = first_dt});
    if (state.is_over()) return;
    if (freed()) continue;
    if (wanted < state.last.residual)
      state.settle(
          {.tolerance = wanted, .max_iterations = kNoLimit, .first_dt = tuning.near_rest_dt});
    if (state.is_over() || !freed()) return;
  }
}

}  // namespace loosefit::drape
