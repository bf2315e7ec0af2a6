#include "loosefit/solver/linear/multifrontal/sparse_cholesky.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Cholesky>

#include "support/block_matrices.h"
#include "support/law_checker.h"

namespace loosefit::solver {
namespace {

using namespace support;

TEST(SparseCholesky, LargeFrontsSolveLikeADenseFactorisationAlsoAfterAFailure) {
  const particles::BlockMatrix m = cliques(60, 7);
  const std::vector<double> none(m.particles(), 0.0);
  const std::vector<Vec3> rhs = random_field(m.particles());
  const Eigen::VectorXd expected = support::dense(m).ldlt().solve(flat(rhs));
  SparseCholesky<double> cholesky;
  EXPECT_FALSE(cholesky.factorise(m, std::vector<double>(m.particles(), -80.0), {}));
  ASSERT_TRUE(cholesky.factorise(cliques(70, 8), none, {}));  // leaves its numbers behind
  ASSERT_TRUE(cholesky.factorise(m, none, {}));
  std::vector<Vec3> x;
  cholesky.solve(rhs, x);
  EXPECT_LT((flat(x) - expected).norm(), 1e-12 * expected.norm());
}

TEST(SparseCholesky, BitsDependNeitherOnThreadsNorOnWhatWasFactorisedBefore) {
  const particles::BlockMatrix m = cliques(60, 9);
  const std::vector<double> none(m.particles(), 0.0);
  const std::vector<Vec3> rhs = random_field(m.particles());
  std::vector<std::vector<Vec3>> solutions;
  for (std::size_t threads : {1, 2, 4}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    SparseCholesky<float> cholesky;
    for (unsigned seed : {10u, 11u})
      if (threads > 1) {
        ASSERT_TRUE(cholesky.factorise(cliques(70, seed), none, {}));
      }
    ASSERT_TRUE(cholesky.factorise(m, none, {}));
    cholesky.solve(rhs, solutions.emplace_back());
  }
  EXPECT_EQ(solutions[0], solutions[1]);
  EXPECT_EQ(solutions[0], solutions[2]);
}

TEST(SparseCholesky, SaysWhenTheMatrixIsIndefiniteAndRecovers) {
  const int n = 20;
  SparseCholesky<double> cholesky;
  const particles::BlockMatrix m = random_matrix(n, -5, 4);
  EXPECT_FALSE(cholesky.factorise(m, std::vector<double>(n, 0.0), {}));
  EXPECT_TRUE(cholesky.factorise(m, std::vector<double>(n, 100.0), {}));
}

TEST(SparseCholesky, FactorisesAgainToTheSameBitsAfterItsMemoryWasGivenBack) {
  const int n = 30;
  const particles::BlockMatrix m = random_matrix(n, 14, 5);
  const std::vector<Vec3> rhs = random_field(n);
  SparseCholesky<float> cholesky;
  std::vector<Vec3> before, after;
  ASSERT_TRUE(cholesky.factorise(m, std::vector<double>(n, 0.1), {}));
  cholesky.solve(rhs, before);
  cholesky.release();
  ASSERT_TRUE(cholesky.factorise(m, std::vector<double>(n, 0.1), {}));
  cholesky.solve(rhs, after);
  EXPECT_EQ(before, after);
  SparseCholesky<float> unused;
  unused.release();
}

}  // namespace
}  // namespace loosefit::solver
