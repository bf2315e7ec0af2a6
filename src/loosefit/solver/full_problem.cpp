#include "loosefit/solver/full_problem.h"

#include "loosefit/solver/stopwatch.h"

namespace loosefit::solver {

double FullProblem::evaluate(const particles::VectorField& x, particles::VectorField& g) {
  const Stopwatch watch(work_.evaluate);
  return system_.potential_and_gradient(x, g);
}

void FullProblem::assemble(const particles::VectorField& x, particles::HessianKind kind) {
  const Stopwatch watch(work_.assemble);
  tangent_.assemble(x, kind);
}

bool FullProblem::factorise(double shift) {
  shift_ = system_.carried_mass();
  for (double& m : shift_) m *= shift;
  no_unknown_ = system_.no_unknown();
  ++work_.factorisations;
  const Stopwatch watch(work_.factorise);
  return linear_.factorise(tangent_.matrix(), shift_, no_unknown_);
}

void FullProblem::solve(const particles::VectorField& g, particles::VectorField& dx) {
  const Stopwatch watch(work_.solve);
  linear_.solve(g, dx);
  system_.move_followers(dx);
}

double FullProblem::max_step(const particles::VectorField& x, const particles::VectorField& dx) {
  const Stopwatch watch(work_.collide);
  return system_.max_step(x, dx);
}

void FullProblem::begin_step(const particles::VectorField& x, double dt) {
  const Stopwatch watch(work_.refresh);
  system_.begin_step(x, dt);
}

}  // namespace loosefit::solver
