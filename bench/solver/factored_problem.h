#pragma once
#include "loosefit/solver/linear/multifrontal/sparse_cholesky.h"
#include "loosefit/solver/newton_problem.h"
#include "loosefit/solver/solver_work.h"
#include "loosefit/solver/tangent_matrix.h"
#include "method.h"

namespace loosefit::bakeoff {

/// Newton's problem of all particles with one factor in double precision that may serve several
/// iterations, as itself or as a preconditioner.
class FactoredProblem : public solver::NewtonProblem {
 public:
  FactoredProblem(const solver::ParticleSystem& system, const MatrixUse& use)
      : system_(system), use_(use), tangent_(system) {}

  double evaluate(const particles::VectorField& x, particles::VectorField& g) override;
  void restrict(particles::VectorField& v) const override;
  /// Keeps the first matrix where MatrixUse asks for a constant one.
  void assemble(const particles::VectorField& x, particles::HessianKind kind) override;
  bool factorise(double shift) override;
  void solve(const particles::VectorField& g, particles::VectorField& dx) override;
  double max_step(const particles::VectorField& x, const particles::VectorField& dx) override;

  /// z = P⁻¹ r with the last factor.
  void precondition(const particles::VectorField& r, particles::VectorField& z);
  /// hv = H v with the Hessian of the last `assemble`.
  void multiply(const particles::VectorField& v, particles::VectorField& hv) const;
  solver::SolverWork& work() { return work_; }
  const solver::SolverWork& work() const { return work_; }

 private:
  const solver::ParticleSystem& system_;
  MatrixUse use_;
  solver::TangentMatrix tangent_;
  particles::BlockMatrix isotropic_;
  solver::SparseCholesky<double> cholesky_;
  std::vector<double> shift_;
  bool has_constant_ = false;
  solver::SolverWork work_;
};

}  // namespace loosefit::bakeoff
