#pragma once
#include <memory>

#include "loosefit/solver/linear/linear_solver.h"

namespace loosefit::solver {

/// CHOLMOD's supernodal Cholesky in double precision (Chen, Davis, Hager and Rajamanickam 2008),
/// the oracle of our own factor in tests and its rival in bench/linear. The matrix is handed over
/// entry by entry; the symbolic analysis is kept while the pattern stays the same, and the
/// fill-reducing order (fill_order.h) while the number of particles does.
class CholmodSolver : public LinearSolver {
 public:
  CholmodSolver();
  ~CholmodSolver() override;

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
