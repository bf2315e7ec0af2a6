#include "factored_problem.h"

#include "loosefit/solver/stopwatch.h"

namespace loosefit::bakeoff {

double FactoredProblem::evaluate(const particles::VectorField& x, particles::VectorField& g) {
  const solver::Stopwatch watch(work_.evaluate);
  return system_.potential_and_gradient(x, g);
}

void FactoredProblem::restrict(particles::VectorField& v) const {
  if (!system_.held.empty())
    for (std::size_t i = 0; i < v.size(); ++i)
      if (system_.held[i]) v[i].setZero();
}

void FactoredProblem::assemble(const particles::VectorField& x, particles::HessianKind kind) {
  if (use_.constant && has_constant_) return;
  const solver::Stopwatch watch(work_.assemble);
  tangent_.assemble(x, kind);
  has_constant_ = use_.constant;
  if (use_.kind != MatrixUse::Kind::isotropic) return;
  isotropic_ = tangent_.matrix();
  for (std::size_t k = 0; k < isotropic_.blocks().size(); ++k) {
    Mat3& block = isotropic_.block(static_cast<int>(k));
    block = block.trace() * Mat3::Identity();
  }
}

bool FactoredProblem::factorise(double shift) {
  shift_.resize(system_.particles());
  for (int i = 0; i < system_.particles(); ++i) shift_[i] = shift * system_.mass[i];
  ++work_.factorisations;
  const solver::Stopwatch watch(work_.factorise);
  const bool isotropic = use_.kind == MatrixUse::Kind::isotropic;
  return cholesky_.factorise(isotropic ? isotropic_ : tangent_.matrix(), shift_, system_.held);
}

void FactoredProblem::solve(const particles::VectorField& g, particles::VectorField& dx) {
  const solver::Stopwatch watch(work_.solve);
  precondition(g, dx);
  for (Vec3& d : dx) d = -d;
}

double FactoredProblem::max_step(const particles::VectorField& x,
                                 const particles::VectorField& dx) {
  const solver::Stopwatch watch(work_.collide);
  return system_.max_step(x, dx);
}

void FactoredProblem::precondition(const particles::VectorField& r, particles::VectorField& z) {
  cholesky_.solve(r, z);
  restrict(z);
}

void FactoredProblem::multiply(const particles::VectorField& v, particles::VectorField& hv) const {
  hv.assign(v.size(), Vec3::Zero());
  tangent_.matrix().add_product(v, hv);
  restrict(hv);
}

}  // namespace loosefit::bakeoff
