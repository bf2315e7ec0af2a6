#pragma once
#include <string>

#include "loosefit/solver/particle_system.h"
#include "loosefit/solver/solver_work.h"

namespace loosefit::solver {

/// Why and where settling stopped.
struct SettleOutcome {
  enum class Reason { converged, iteration_limit, stopped, stuck, diverged } reason = Reason::stuck;
  double residual = 0, residual_max = 0;
  int worst_particle = -1;
  SolverWork work;
  std::string text() const;
};

/// Force balance that is sought.
struct RestGoal {
  double norm;     ///< ‖F‖₂/‖W‖₂ [–]
  double largest;  ///< max‖F_i‖ / mean‖W_i‖ [–]
};

/// Measures the static force balance (no inertia, no viscosity) into the outcome; true when
/// settling is over because it is met or not a number, with the reason set. gradient: ∂Π/∂x with
/// friction renewed by the caller.
bool check_convergence(const ParticleSystem& system, const particles::VectorField& gradient,
                       const RestGoal& goal, SettleOutcome& outcome);
/// The same at x: renews friction first.
bool check_convergence_at(const ParticleSystem& system, const particles::VectorField& x,
                          const RestGoal& goal, SettleOutcome& outcome);

}  // namespace loosefit::solver
