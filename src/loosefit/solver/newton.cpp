#include "loosefit/solver/newton.h"

#include "loosefit/solver/stopwatch.h"

namespace loosefit::solver {

void Newton::restart(double max_move) {
  step_.set_max_move(max_move);
  problem_.work() = {};
  evaluated_ = false;
}

void Newton::begin_step(const particles::VectorField& x, double dt) {
  problem_.begin_step(x, dt);
  evaluated_ = false;
}

const particles::VectorField& Newton::gradient(const particles::VectorField& x) {
  if (!evaluated_ || x != at_.x) {
    at_.potential = problem_.evaluate(x, at_.gradient);
    at_.x = x;
    evaluated_ = true;
  }
  return at_.gradient;
}

StepOutcome Newton::iterate(particles::VectorField& x, const particles::VectorField& target,
                            double dt) {
  const InertiaTerm inertia(system_, target, dt);
  gradient(x);
  ++problem_.work().iterations;
  const StepOutcome outcome = step_.take(problem_, inertia, at_);
  if (!outcome.moved) return outcome;
  x = at_.x;
  // Below round-off no region can be told from noise.
  if (!outcome.below_round_off) relax_region(x, inertia);
  return outcome;
}

void Newton::relax_region(particles::VectorField& x, const InertiaTerm& inertia) {
  if (system_.particles() < tuning_.region.min_particles) return;
  const Stopwatch watch(problem_.work().region);
  particles::VectorField force = at_.gradient;
  inertia.add_gradient(x, force);
  const auto steps =
      region_.relax(x, force, inertia, step_.max_move(), problem_.order(), problem_.tangent());
  if (!steps) return;
  problem_.work().regional += *steps;
  evaluated_ = false;  // a search also changes which pairs are in contact
}

}  // namespace loosefit::solver
