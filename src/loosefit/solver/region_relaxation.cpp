#include "loosefit/solver/region_relaxation.h"

namespace loosefit::solver {

std::optional<int> RegionRelaxation::relax(particles::VectorField& x,
                                           const particles::VectorField& force,
                                           const InertiaTerm& inertia, double max_move,
                                           const std::vector<int>& order, TangentMatrix& tangent) {
  ResidualRegion region = residual_region(tangent.matrix(), force, tuning_, system_.on_plate());
  if (region.empty()) return std::nullopt;
  problem_.set_region(std::move(region), tangent, order);
  step_.set_max_move(max_move);
  int steps = 0;
  try {
    system_.set_active_set(&problem_.active_set());
    steps = relax_active_set(x, inertia);
  } catch (...) {
    system_.set_active_set(nullptr);
    throw;
  }
  system_.set_active_set(nullptr);
  return steps;
}

int RegionRelaxation::relax_active_set(particles::VectorField& x, const InertiaTerm& inertia) {
  Iterate at;
  at.x = x;
  at.potential = problem_.evaluate(at.x, at.gradient);
  double enough = 0;
  int steps = 0;
  while (steps < tuning_.max_steps) {
    const StepOutcome step = step_.take(problem_, inertia, at, enough);
    if (steps == 0) enough = tuning_.relaxed * step.force;
    if (!step.moved) break;
    ++steps;
  }
  x = at.x;
  return steps;
}

}  // namespace loosefit::solver
