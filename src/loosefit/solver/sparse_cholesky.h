#pragma once
#include <Eigen/Core>
#include <memory>
#include <vector>

#include "loosefit/particles/block_matrix.h"

namespace loosefit {

/// Multifrontal sparse Cholesky of a block matrix (Duff and Reid 1983; Liu 1992): dense BLAS
/// kernels on the fronts, branches of the elimination tree side by side on all cores. Sums are
/// taken in the order of the tree, so the bits do not depend on the number of threads. The
/// fill-reducing order is found once on the block graph and reused while contacts come and go.
template <class Real>
class SparseCholesky {
 public:
  SparseCholesky();
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  /// Factorises A + diag(shift), rows of held particles replaced by identity. shift has one entry
  /// per particle [N/m]; held may be empty. False when the matrix is not positive definite; the
  /// factor is then lost. \throws SolverFailure when memory runs out.
  bool factorise(const BlockMatrix& a, const std::vector<double>& shift,
                 const std::vector<char>& held);
  /// Solves with the last successful factorisation. \pre factorise returned true
  void solve(const std::vector<Vec3>& rhs, std::vector<Vec3>& x) const;
  /// Gives the memory of the factor back; what is known of the pattern stays.
  void release();
  /// The elimination order in use: the k-th particle. Empty before the first `factorise`.
  const std::vector<int>& order() const;
  /// Takes this order for the matrices of as many particles that follow; others find their own.
  void set_order(std::vector<int> order);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace loosefit
