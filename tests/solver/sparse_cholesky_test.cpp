#include "loosefit/solver/sparse_cholesky.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Cholesky>
#include <random>

#include "support/law_checker.h"

namespace loosefit {
namespace {

/// Random symmetric blocks, the diagonal ones larger by `diagonal`.
BlockMatrix filled(BlockPattern pattern, double diagonal, unsigned seed) {
  std::mt19937 rng(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  pattern.compress();
  BlockMatrix m(pattern);
  for (int j = 0; j < m.particles(); ++j)
    for (int i : pattern.rows_of_column()[j]) {
      Mat3 block;
      for (int k = 0; k < 9; ++k) block(k / 3, k % 3) = u(rng);
      if (i == j) block = (block + block.transpose() + diagonal * Mat3::Identity()).eval();
      m.add(i, j, block);
    }
  return m;
}

/// A chain with some far couplings.
BlockMatrix random_matrix(int n, double diagonal, unsigned seed) {
  BlockPattern pattern(n);
  for (int i = 1; i < n; ++i) pattern.add(i, i - 1);
  for (int i = 0; i < n; i += 3) pattern.add(i, (7 * i + 5) % n);
  return filled(std::move(pattern), diagonal, seed);
}

std::vector<Vec3> random_field(int n) {
  std::mt19937 rng(9);
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<Vec3> f(n);
  for (Vec3& v : f) v = Vec3(u(rng), u(rng), u(rng));
  return f;
}

Eigen::VectorXd flat(const std::vector<Vec3>& f) {
  Eigen::VectorXd v(3 * static_cast<long>(f.size()));
  for (std::size_t i = 0; i < f.size(); ++i) v.segment<3>(3 * static_cast<long>(i)) = f[i];
  return v;
}

TEST(SparseCholesky, SolvesLikeADenseFactorisationWithShiftsAndHeldParticles) {
  const int n = 40;
  SparseCholesky<double> cholesky;
  for (unsigned seed : {1u, 2u, 3u}) {  // the order is reused, the values and holds change
    const BlockMatrix m = random_matrix(n, 14, seed);
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

/// Two cliques and a third that both of them touch: fronts that are shared out in blocks, and pass
/// their borders on.
BlockMatrix cliques(double diagonal, unsigned seed) {
  constexpr int kClique = 110, kShared = 50;
  BlockPattern pattern(2 * kClique + kShared);
  for (int first : {0, kClique}) {
    std::vector<int> clique;
    for (int i = 0; i < kClique; ++i) clique.push_back(first + i);
    for (int i = 0; i < kShared; ++i) clique.push_back(2 * kClique + i);
    pattern.add_clique(clique);
  }
  return filled(std::move(pattern), diagonal, seed);
}

TEST(SparseCholesky, LargeFrontsSolveLikeADenseFactorisationAlsoAfterAFailure) {
  const BlockMatrix m = cliques(60, 7);
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
  const BlockMatrix m = cliques(60, 9);
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
  const BlockMatrix m = random_matrix(n, -5, 4);
  EXPECT_FALSE(cholesky.factorise(m, std::vector<double>(n, 0.0), {}));
  EXPECT_TRUE(cholesky.factorise(m, std::vector<double>(n, 100.0), {}));
}

TEST(SparseCholesky, FactorisesAgainToTheSameBitsAfterItsMemoryWasGivenBack) {
  const int n = 30;
  const BlockMatrix m = random_matrix(n, 14, 5);
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
}  // namespace loosefit
