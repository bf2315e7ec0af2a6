#include "loosefit/solver/full_problem.h"

#include "loosefit/solver/stopwatch.h"

namespace loosefit {

double FullProblem::evaluate(const VectorField& x, VectorField& g) {
  const Stopwatch watch(work_.evaluate);
  return system_.potential_and_gradient(x, g);
}

void FullProblem::assemble(const VectorField& x, HessianKind kind) {
  const Stopwatch watch(work_.assemble);
  tangent_.assemble(x, kind);
}

bool FullProblem::factorise(double shift) {
  shift_.resize(system_.particles());
  for (int i = 0; i < system_.particles(); ++i) shift_[i] = shift * system_.mass[i];
  ++work_.factorisations;
  const Stopwatch watch(work_.factorise);
  return linear_.factorise(tangent_.matrix(), shift_, system_.held);
}

void FullProblem::solve(const VectorField& g, VectorField& dx) {
  const Stopwatch watch(work_.solve);
  linear_.solve(g, dx);
}

double FullProblem::max_step(const VectorField& x, const VectorField& dx) {
  const Stopwatch watch(work_.collide);
  return system_.max_step(x, dx);
}

void FullProblem::begin_step(const VectorField& x, double dt) {
  const Stopwatch watch(work_.refresh);
  system_.begin_step(x, dt);
}

}  // namespace loosefit
