#pragma once
#include <vector>

#include "loosefit/solver/backoff.h"
#include "loosefit/solver/linear/linear_tuning.h"
#include "loosefit/solver/linear/multifrontal/sparse_cholesky.h"

namespace loosefit::solver {

/// The linear system of a Newton step, (A + diag(shift)) dx = −g. Its factor is kept in single
/// precision, at half the cost, and is the preconditioner of conjugate gradients on the system
/// itself in double precision, which take away what the rounding left (as iterative refinement
/// does, Higham and Mary 2022). Where single precision will not do, double precision takes over for
/// good.
class NewtonSystem {
 public:
  explicit NewtonSystem(const PrecisionTuning& tuning = {})
      : tuning_(tuning), try_double_(tuning.max_pause) {}

  /// As SparseCholesky::factorise.
  bool factorise(const particles::BlockMatrix& a, const std::vector<double>& shift,
                 const std::vector<char>& held);
  /// dx to a residual of tuning.accuracy ‖g‖; a direction of descent in any case. Held particles
  /// get zero. Uses the arguments of factorise again. \pre factorise returned true
  void solve(const std::vector<Vec3>& g, std::vector<Vec3>& dx);
  bool in_double() const { return in_double_; }
  /// As SparseCholesky::order and set_order; a new order also starts in single precision again.
  const std::vector<int>& order() const { return used_double_ ? double_.order() : single_.order(); }
  void set_order(const std::vector<int>& order) {
    in_double_ = false;
    broke_down_ = 0;
    single_.set_order(order);
    double_.set_order(order);
  }

 private:
  bool conjugate_gradients(const std::vector<Vec3>& b, std::vector<Vec3>& x);
  void multiply(const std::vector<Vec3>& x, std::vector<Vec3>& y) const;
  void drop_held(std::vector<Vec3>& v) const;

  PrecisionTuning tuning_;
  SparseCholesky<float> single_;
  SparseCholesky<double> double_;
  bool in_double_ = false;    ///< from now on
  bool used_double_ = false;  ///< for the last factor
  int broke_down_ = 0;        ///< factors in single precision of definite matrices, in a row
  Backoff try_double_;
  const particles::BlockMatrix* a_ = nullptr;
  const std::vector<double>* shift_ = nullptr;
  const std::vector<char>* held_ = nullptr;
};

}  // namespace loosefit::solver
