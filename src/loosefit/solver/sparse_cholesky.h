#pragma once
#include <Eigen/Core>
#include <memory>
#include <vector>

#include "loosefit/particles/block_matrix.h"

namespace loosefit {

/// Supernodal sparse Cholesky of a block matrix (CHOLMOD; Chen, Davis, Hager and Rajamanickam
/// 2008). The fill-reducing order is found once on the block graph and reused while contacts come
/// and go. The only source file that includes CHOLMOD.
class SparseCholesky {
 public:
  SparseCholesky();
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  /// Factorises A + diag(shift), rows of held particles replaced by identity. shift has one entry
  /// per particle [N/m]; held may be empty. False when the matrix is not positive definite.
  bool factorise(const BlockMatrix& a, const std::vector<double>& shift,
                 const std::vector<char>& held);
  /// Solves with the last successful factorisation. \pre factorise returned true
  void solve(const std::vector<Vec3>& rhs, std::vector<Vec3>& x);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace loosefit
