#include "loosefit/drape/phases/leave_saddle.h"

#include "loosefit/drape/phases/certify_state.h"
#include "loosefit/drape/phases/free_penetrations.h"
#include "loosefit/solver/stability.h"

namespace loosefit::drape {
namespace {

std::vector<Vec3> moved(std::vector<Vec3> x, const std::vector<Vec3>& along, double length) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += length * along[i];
  return x;
}

}  // namespace

void leave_saddle(ClothState& state) {
  const CertifyTuning& tuning = state.tuning.certify;
  if (!state.saddle) {
    state.keep(state.saddle, state.certificate.residual);
    state.saddle->stop = state.how_it_ended();
  }
  const solver::ParticleSystem& system = state.model->system();
  const auto mode = solver::lowest_unstable_mode(system, state.x);
  if (!mode) return;
  // Both sides go down; the steeper one is taken.
  const auto& v = mode->direction;
  const bool forward = system.potential(moved(state.x, v, tuning.saddle_step)) <=
                       system.potential(moved(state.x, v, -tuning.saddle_step));
  std::vector<Vec3> displacement(v);
  for (Vec3& d : displacement) d *= forward ? tuning.saddle_step : -tuning.saddle_step;
  state.move_without_collision(displacement);
  settle_without_penetrations(state, state.tuning.penetrations.first_dt);
  state.attempts[RecoveryKind::nearer_to_rest] = 0;
  measure_certificate(state);
}

}  // namespace loosefit::drape
