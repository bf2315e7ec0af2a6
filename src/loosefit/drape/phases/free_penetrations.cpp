#include "loosefit/drape/phases/free_penetrations.h"

#include <algorithm>

#include "loosefit/drape/raise_offsets.h"

namespace loosefit::drape {

bool find_penetrations(ClothState& state) {
  state.penetrating = penetrating_triangles(state.model->mesh(), state.body->body, state.x);
  const bool low = !state.clear || state.last.residual < state.clear->residual;
  if (low && state.penetrating.empty()) state.keep(state.clear, state.last.residual);
  return !state.penetrating.empty();
}

void raise_offsets(ClothState& state) {
  std::vector<double> half_thickness;
  for (const ClothLayer& layer : state.layers)
    half_thickness.push_back(0.5 * layer.material.thickness);
  state.offsets_raised =
      raise_offsets_at_penetrations(*state.model, *state.body, state.x, half_thickness,
                                    state.penetrating, state.times_cut, state.tuning.penetrations);
  state.report.held_off_triangles = static_cast<int>(state.times_cut.size());
}

void free_penetrations(ClothState& state) {
  const PenetrationTuning& tuning = state.tuning.penetrations;
  const double wanted = state.options.residual_tolerance;
  state.times_cut.clear();
  state.lowest.reset(), state.clear.reset(), state.saddle.reset();
  state.attempts[RecoveryKind::raise_offsets] = 0;
  state.loosen_friction();
  // Penetrations are looked for long before the last digits of the balance are sought, and what is
  // about to cut is treated alike.
  for (std::size_t i = 0; i < tuning.look_tolerances.size(); ++i) {
    state.settle({std::max(tuning.look_tolerances[i], wanted), tuning.look_iterations,
                  tuning.look_first_dt[i]});
    if (state.is_over()) return;
    find_penetrations(state);
    raise_offsets(state);
  }
  state.stick();
  settle_without_penetrations(state, tuning.first_dt);
}

void settle_without_penetrations(ClothState& state, double first_dt) {
  const PenetrationTuning& tuning = state.tuning.penetrations;
  const double wanted = state.options.residual_tolerance;
  const auto freed = [&] { return state.recover(RecoveryPoint::at_rest) && state.offsets_raised; };
  // A round for the last digits, while there are still penetrations, would be thrown away.
  for (;; first_dt = tuning.near_rest_dt) {
    state.settle({std::max(tuning.tolerance, wanted), kNoLimit, first_dt});
    if (state.is_over()) return;
    if (freed()) continue;
    if (wanted < state.last.residual) state.settle({wanted, kNoLimit, tuning.near_rest_dt});
    if (state.is_over() || !freed()) return;
  }
}

}  // namespace loosefit::drape
