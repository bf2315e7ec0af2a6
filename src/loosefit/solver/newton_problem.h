#pragma once
#include "loosefit/particles/energy.h"

namespace loosefit::solver {

/// What a Newton step works on: the potential Π as a function of the particles that may move, its
/// Hessian and linear systems with it. FullProblem: all particles; RegionProblem: an active set.
/// Fields have an entry for every particle.
class NewtonProblem {
 public:
  virtual ~NewtonProblem() = default;
  /// Π(x) [J], up to a constant; g = ∂Π/∂x [N], void for particles that may not move.
  virtual double evaluate(const particles::VectorField& x, particles::VectorField& g) = 0;
  /// Makes forces on particles that may not move zero.
  virtual void restrict(particles::VectorField& force) const = 0;
  virtual void assemble(const particles::VectorField& x, particles::HessianKind kind) = 0;
  /// Factorises H + shift M, H the last Hessian, shift [1/s²]. False: not positive definite.
  virtual bool factorise(double shift) = 0;
  /// dx = −(H + shift M)⁻¹ g; zero for particles that may not move. \pre factorise returned true
  virtual void solve(const particles::VectorField& g, particles::VectorField& dx) = 0;
  /// StepLimit::max_step of all energies.
  virtual double max_step(const particles::VectorField& x, const particles::VectorField& dx) = 0;
};

}  // namespace loosefit::solver
