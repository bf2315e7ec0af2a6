#pragma once
#include <vector>

#include "loosefit/particles/block_matrix.h"

namespace loosefit::solver {

/// A direct solver of (A + diag(shift)) x = b for a symmetric positive definite block matrix A:
/// one factorisation, then any number of right-hand sides. Implemented by SparseCholesky (our
/// multifrontal factor), of which NewtonSystem keeps one in either precision, and CholmodSolver
/// (CHOLMOD's supernodal one), the oracle of the tests and a row of bench/linear.
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;

  /// Factorises A + diag(shift), rows and columns of held particles replaced by identity. shift has
  /// one entry per particle [N/m]; held may be empty. False when the matrix is not positive
  /// definite; the factor is then lost. \throws std::bad_alloc when memory runs out, SolverFailure.
  virtual bool factorise(const particles::BlockMatrix& a, const std::vector<double>& shift,
                         const std::vector<char>& held) = 0;
  /// Solves with the last successful factorisation. \pre factorise returned true
  virtual void solve(const std::vector<Vec3>& rhs, std::vector<Vec3>& x) const = 0;
  /// Gives the memory of the factor back; what is known of the pattern stays.
  virtual void release() = 0;
  /// The elimination order in use: the k-th particle. Empty before the first `factorise`.
  virtual const std::vector<int>& order() const = 0;
  /// Takes this order for the matrices of as many particles that follow; others find their own.
  virtual void set_order(std::vector<int> order) = 0;
};

}  // namespace loosefit::solver
