#pragma once
#include "loosefit/solver/linear/newton_system.h"
#include "loosefit/solver/newton_problem.h"
#include "loosefit/solver/solver_work.h"
#include "loosefit/solver/tangent_matrix.h"

namespace loosefit::solver {

/// Newton's problem of all particles of a system. Counts its work and keeps the pattern of the
/// matrix between calls.
class FullProblem : public NewtonProblem {
 public:
  explicit FullProblem(const ParticleSystem& system, const PrecisionTuning& tuning = {})
      : system_(system), tangent_(system), linear_(tuning) {}

  double evaluate(const particles::VectorField& x, particles::VectorField& g) override;
  void restrict(particles::VectorField& /*force*/) const override {}
  void assemble(const particles::VectorField& x, particles::HessianKind kind) override;
  bool factorise(double shift) override;
  void solve(const particles::VectorField& g, particles::VectorField& dx) override;
  double max_step(const particles::VectorField& x, const particles::VectorField& dx) override;
  /// LaggedState::begin_step of all energies.
  void begin_step(const particles::VectorField& x, double dt);

  SolverWork& work() { return work_; }
  const SolverWork& work() const { return work_; }
  TangentMatrix& tangent() { return tangent_; }
  /// Elimination order of the last factor.
  const std::vector<int>& order() const { return linear_.order(); }

 private:
  const ParticleSystem& system_;
  TangentMatrix tangent_;
  NewtonSystem linear_;
  std::vector<double> shift_;  ///< shift times mass [kg/s²]
  std::vector<char> no_unknown_;
  SolverWork work_;
};

}  // namespace loosefit::solver
