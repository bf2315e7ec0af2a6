#include "loosefit/drape/phases/free_penetrations.h"

#include <algorithm>
#include <limits>

#include "loosefit/drape/left_to_go.h"
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
    // Worn cloth has its points and lies at rest already: softer, it would sink and slide.
    state.model->set_hardening(state.worn ? 1 : tuning.look_hardening[i]);
    state.settle({std::max(tuning.look_tolerances[i], state.options.residual_tolerance),
                  tuning.look_iterations, tuning.look_first_dt[i]});
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

namespace {

/// Whether it is near enough to rest for grade B.
bool is_near_enough(ClothState& state) {
  state.model->system().begin_step(state.x, std::numeric_limits<double>::infinity());
  const auto left = left_to_go(state.model->system(), state.model->mesh().triangles, state.x);
  return left && left->is_grade_b();
}

/// Settles to that residual and frees what cuts then, in turn. A round for the last digits, while
/// there are still penetrations, would be thrown away.
void settle_free(ClothState& state, double wanted, double first_dt) {
  const PenetrationTuning& tuning = state.tuning.penetrations;
  const auto freed = [&] { return state.recover(RecoveryPoint::at_rest); };
  for (;; first_dt = tuning.near_rest_dt) {
    state.settle({std::max(tuning.tolerance, wanted), kNoLimit, first_dt});
    if (state.is_over()) return;
    if (freed()) continue;
    if (wanted < state.last.residual) state.settle({wanted, kNoLimit, tuning.near_rest_dt});
    if (state.is_over() || !freed()) return;
  }
}

}  // namespace

void settle_without_penetrations(ClothState& state, double first_dt) {
  if (state.options.grade == solver::RestGrade::b &&
      state.options.integrator == IntegratorKind::quasi_static)
    for (const double tolerance : state.tuning.certify.ask_tolerances) {
      settle_free(state, tolerance, first_dt);
      if (state.is_over() || is_near_enough(state)) return;
      first_dt = state.tuning.penetrations.near_rest_dt;
    }
  settle_free(state, state.options.residual_tolerance, first_dt);
}

}  // namespace loosefit::drape
