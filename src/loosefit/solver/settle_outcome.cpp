#include "loosefit/solver/settle_outcome.h"

#include <cmath>
#include <limits>

namespace loosefit::solver {

bool check_convergence_at(const ParticleSystem& system, const particles::VectorField& x,
                          const RestGoal& goal, SettleOutcome& outcome) {
  system.begin_step(x, std::numeric_limits<double>::infinity());
  return check_convergence(system, system.gradient(x), goal, outcome);
}

bool check_convergence(const ParticleSystem& system, const particles::VectorField& gradient,
                       const RestGoal& goal, SettleOutcome& outcome) {
  const Residual r = residual_of(system, gradient);
  outcome.residual = r.norm;
  outcome.residual_max = r.largest;
  outcome.worst_particle = r.worst_particle;
  if (!std::isfinite(r.norm)) outcome.reason = SettleOutcome::Reason::diverged;
  const bool met = r.norm <= goal.norm && r.largest <= goal.largest;
  if (met) outcome.reason = SettleOutcome::Reason::converged;
  return !std::isfinite(r.norm) || met;
}

std::string SettleOutcome::text() const {
  switch (reason) {
    case Reason::converged:
      return "converged";
    case Reason::iteration_limit:
      return "iteration limit";
    case Reason::stopped:
      return "time budget";
    case Reason::stuck:
      return "no further descent";
    case Reason::diverged:
      return "the time stepping diverged";
  }
  return {};
}

}  // namespace loosefit::solver
