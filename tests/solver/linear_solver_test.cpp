#include "loosefit/solver/linear/linear_solver.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "loosefit/solver/linear/cholmod_solver.h"
#include "loosefit/solver/linear/multifrontal/sparse_cholesky.h"
#include "support/block_matrices.h"
#include "support/law_checker.h"

namespace loosefit::solver {
namespace {

using namespace support;

template <class Solver>
class LinearSolvers : public ::testing::Test {};
using Solvers = ::testing::Types<SparseCholesky<double>, CholmodSolver>;
TYPED_TEST_SUITE(LinearSolvers, Solvers);

TYPED_TEST(LinearSolvers, SolveLikeADenseFactorisationWithShiftsAndHeldParticles) {
  const int n = 40;
  TypeParam cholesky;
  for (unsigned seed : {1u, 2u, 3u}) {  // the order is reused, the values and holds change
    const particles::BlockMatrix m = random_matrix(n, 14, seed);
    std::vector<double> shift(n);
    std::vector<char> held(n, 0);
    for (int i = 0; i < n; ++i) shift[i] = 0.1 * i;
    if (seed > 1) held[3] = held[17] = held[39] = 1;
    Eigen::MatrixXd dense = support::dense(m);
    std::vector<Vec3> rhs = random_field(n);
    for (int i = 0; i < n; ++i) {
      dense.block<3, 3>(3 * i, 3 * i) += shift[i] * Mat3::Identity();
      if (!held[i]) continue;
      rhs[i].setZero();
      dense.middleRows(3 * i, 3).setZero();
      dense.middleCols(3 * i, 3).setZero();
      dense.block<3, 3>(3 * i, 3 * i).setIdentity();
    }
    ASSERT_TRUE(cholesky.factorise(m, shift, held));
    std::vector<Vec3> x;
    cholesky.solve(rhs, x);
    const Eigen::VectorXd expected = dense.ldlt().solve(flat(rhs));
    EXPECT_LT((flat(x) - expected).norm(), 1e-12 * expected.norm());
  }
}

TYPED_TEST(LinearSolvers, SayWhenTheMatrixIsIndefiniteAndRecover) {
  const int n = 20;
  TypeParam cholesky;
  const particles::BlockMatrix m = random_matrix(n, -5, 4);
  EXPECT_FALSE(cholesky.factorise(m, std::vector<double>(n, 0.0), {}));
  ASSERT_TRUE(cholesky.factorise(m, std::vector<double>(n, 100.0), {}));
  std::vector<Vec3> x;
  const std::vector<Vec3> rhs = random_field(n);
  cholesky.solve(rhs, x);
  const Eigen::MatrixXd dense = support::dense(m) + 100 * Eigen::MatrixXd::Identity(3 * n, 3 * n);
  EXPECT_LT((dense * flat(x) - flat(rhs)).norm(), 1e-12 * flat(rhs).norm());
}

TYPED_TEST(LinearSolvers, TakeTheOrderThatIsGivenAndFactoriseAgainAfterRelease) {
  const int n = 30;
  TypeParam cholesky;
  std::vector<int> order(n);
  for (int i = 0; i < n; ++i) order[i] = (7 * i + 3) % n;
  cholesky.set_order(order);
  const particles::BlockMatrix m = random_matrix(n, 14, 5);
  const std::vector<Vec3> rhs = random_field(n);
  std::vector<Vec3> before, after;
  ASSERT_TRUE(cholesky.factorise(m, std::vector<double>(n, 0.1), {}));
  EXPECT_EQ(cholesky.order().size(), order.size());
  cholesky.solve(rhs, before);
  cholesky.release();
  ASSERT_TRUE(cholesky.factorise(m, std::vector<double>(n, 0.1), {}));
  cholesky.solve(rhs, after);
  EXPECT_LT((flat(before) - flat(after)).norm(), 1e-13 * flat(before).norm());
}

TEST(MultifrontalFactor, SolvesAsCholmodDoesOnSheetsWhosePatternChanges) {
  SparseCholesky<double> own;
  SparseCholesky<float> rough;
  CholmodSolver oracle;
  for (const int n : {25, 40, 41}) {
    const particles::BlockMatrix m = sheet(n, 40, n);
    const std::vector<double> shift(m.particles(), 0.5);
    std::vector<char> held(m.particles(), 0);
    held[n] = held[3 * n + 2] = 1;
    std::vector<Vec3> rhs = random_field(m.particles());
    rhs[n].setZero(), rhs[3 * n + 2].setZero();
    std::vector<Vec3> x, y, z;
    ASSERT_TRUE(oracle.factorise(m, shift, held));
    ASSERT_TRUE(own.factorise(m, shift, held));
    ASSERT_TRUE(rough.factorise(m, shift, held));
    oracle.solve(rhs, x);
    own.solve(rhs, y);
    rough.solve(rhs, z);
    EXPECT_LT((flat(x) - flat(y)).norm(), 1e-12 * flat(x).norm()) << n;
    EXPECT_LT((flat(x) - flat(z)).norm(), 1e-4 * flat(x).norm()) << n;
  }
}

}  // namespace
}  // namespace loosefit::solver
