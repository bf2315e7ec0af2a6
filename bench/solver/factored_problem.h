#pragma once
#include "loosefit/solver/linear/multifrontal/sparse_cholesky.h"
#include "loosefit/solver/newton_problem.h"
#include "loosefit/solver/solver_work.h"
#include "loosefit/solver/tangent_matrix.h"
#include "method.h"

namespace loosefit::bakeoff {

/// Newton's problem of all particles with one factor in double precision that may serve several
/// iterations, as itself or as a preconditioner.
class FactoredProblem : public NewtonProblem {
 public:
  FactoredProblem(const ParticleSystem& system, const MatrixUse& use)
      : system_(system), use_(use), tangent_(system) {}

  double evaluate(const VectorField& x, VectorField& g) override;
  void restrict(VectorField& v) const override;
  /// Keeps the first matrix where MatrixUse asks for a constant one.
  void assemble(const VectorField& x, HessianKind kind) override;
  bool factorise(double shift) override;
  void solve(const VectorField& g, VectorField& dx) override;
  double max_step(const VectorField& x, const VectorField& dx) override;

  /// z = P⁻¹ r with the last factor.
  void precondition(const VectorField& r, VectorField& z);
  /// hv = H v with the Hessian of the last `assemble`.
  void multiply(const VectorField& v, VectorField& hv) const;
  SolverWork& work() { return work_; }
  const SolverWork& work() const { return work_; }

 private:
  const ParticleSystem& system_;
  MatrixUse use_;
  TangentMatrix tangent_;
  BlockMatrix isotropic_;
  SparseCholesky<double> cholesky_;
  std::vector<double> shift_;
  bool has_constant_ = false;
  SolverWork work_;
};

}  // namespace loosefit::bakeoff
