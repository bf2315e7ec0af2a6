#pragma once
#include <Eigen/Core>
#include <memory>
#include <vector>

#include "loosefit/solver/linear/linear_solver.h"

namespace loosefit::solver {

/// Multifrontal sparse Cholesky of a block matrix (Duff and Reid 1983; Liu 1992): dense BLAS
/// kernels on the fronts, branches of the elimination tree side by side on all cores. Sums are
/// taken in the order of the tree, so the bits do not depend on the number of threads. The
/// fill-reducing order is found once on the block graph and reused while contacts come and go.
template <class Real>
class SparseCholesky : public LinearSolver {
 public:
  SparseCholesky();
  ~SparseCholesky() override;
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  bool factorise(const particles::BlockMatrix& a, const std::vector<double>& shift,
                 const std::vector<char>& held) override;
  void solve(const std::vector<Vec3>& rhs, std::vector<Vec3>& x) const override;
  void release() override;
  const std::vector<int>& order() const override;
  void set_order(std::vector<int> order) override;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace loosefit::solver
