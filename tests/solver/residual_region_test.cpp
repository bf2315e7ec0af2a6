#include "loosefit/solver/residual_region.h"

#include <gtest/gtest.h>

#include "loosefit/solver/linear/multifrontal/sparse_cholesky.h"
#include "support/law_checker.h"

namespace loosefit::solver {
namespace {

/// A chain of n particles with distinct blocks, positive definite.
particles::BlockMatrix chain(int n) {
  particles::BlockPattern pattern(n);
  for (int i = 1; i < n; ++i) pattern.add(i, i - 1);
  pattern.compress();
  particles::BlockMatrix m(pattern);
  for (int i = 0; i < n; ++i) {
    m.add(i, i, (10.0 + i) * Mat3::Identity());
    if (i > 0) m.add(i, i - 1, -Mat3::Constant(1 + 0.01 * i));
  }
  return m;
}

RegionTuning bounds(double force, double seeds, int rings, double extent) {
  RegionTuning t;
  t.force_share = force;
  t.max_seeds = seeds;
  t.rings = rings;
  t.max_extent = extent;
  return t;
}

TEST(ResidualRegion, IsTheLargestForcesAndTheRingsRoundThem) {
  const particles::BlockMatrix m = chain(100);
  particles::VectorField force(100, Vec3(1e-4, 0, 0));
  force[20] = Vec3(0, 3, 0);
  force[70] = Vec3(0, 0, -2);
  force[71] = Vec3(0.5, 0, 0);
  const ResidualRegion r = residual_region(m, force, bounds(0.97, 0.1, 2, 1));
  EXPECT_EQ(r.particles, (std::vector<int>{18, 19, 20, 21, 22, 68, 69, 70, 71, 72}));
  for (int i = 0; i < 100; ++i) {
    const auto at = std::find(r.particles.begin(), r.particles.end(), i);
    EXPECT_EQ(r.index[i], at == r.particles.end() ? -1 : at - r.particles.begin());
  }
}

TEST(ResidualRegion, StopsGrowingAtItsExtent) {
  const particles::BlockMatrix m = chain(100);
  particles::VectorField force(100, Vec3::Zero());
  force[50] = Vec3(1, 0, 0);
  EXPECT_EQ(residual_region(m, force, bounds(0.9, 0.1, 20, 0.08)).particles.size(), 7u);
}

TEST(ResidualRegion, IsEmptyWhereTheForceIsSpreadOutOrNothing) {
  const particles::BlockMatrix m = chain(100);
  EXPECT_TRUE(residual_region(m, particles::VectorField(100, Vec3(1, 0, 0)), bounds(0.9, 0.1, 2, 1))
                  .empty());
  EXPECT_TRUE(residual_region(m, particles::VectorField(100, Vec3::Zero()), bounds(0.9, 0.1, 2, 1))
                  .empty());
}

TEST(RestrictTo, TakesRowsAndColumnsOfTheRegionAndFollowsThePattern) {
  ResidualRegion region;
  region.particles = {2, 3, 7, 8, 9};
  RestrictedBlocks blocks;
  particles::BlockMatrix part;
  const auto expect_part_of = [&](const particles::BlockMatrix& m) {
    region.index.assign(m.particles(), -1);
    for (std::size_t k = 0; k < region.particles.size(); ++k)
      region.index[region.particles[k]] = static_cast<int>(k);
    restrict_to(region, m, part, blocks);
    const Eigen::MatrixXd whole = support::dense(m), small = support::dense(part);
    ASSERT_EQ(small.rows(), 15);
    for (int a = 0; a < 5; ++a)
      for (int b = 0; b < 5; ++b)
        EXPECT_EQ((small.block<3, 3>(3 * a, 3 * b)),
                  (whole.block<3, 3>(3 * region.particles[a], 3 * region.particles[b])));
  };
  expect_part_of(chain(12));
  expect_part_of(chain(14));  // another pattern
}

/// Factorises and solves, and checks the solution.
void expect_solved(SparseCholesky<double>& cholesky, const particles::BlockMatrix& m) {
  const int n = m.particles();
  ASSERT_TRUE(cholesky.factorise(m, std::vector<double>(n, 0.0), {}));
  std::vector<Vec3> rhs(n, Vec3(1, -2, 3)), x;
  cholesky.solve(rhs, x);
  const Eigen::MatrixXd dense = support::dense(m);
  for (int i = 0; i < n; ++i) {
    Vec3 sum = Vec3::Zero();
    for (int j = 0; j < n; ++j) sum += dense.block<3, 3>(3 * i, 3 * j) * x[j];
    EXPECT_LT((sum - rhs[i]).norm(), 1e-12);
  }
}

TEST(SparseCholesky, TakesTheOrderThatIsGivenAndFindsItsOwnForOtherSizes) {
  // From the far end of the chain: a postorder already, so that it stays as it is.
  std::vector<int> order(30);
  for (int i = 0; i < 30; ++i) order[i] = 29 - i;
  SparseCholesky<double> own, given;
  expect_solved(own, chain(30));
  ASSERT_NE(own.order(), order);
  given.set_order(order);
  expect_solved(given, chain(30));
  EXPECT_EQ(given.order(), order);
  expect_solved(given, chain(40));
  particles::BlockPattern pattern(40);
  for (int i = 2; i < 40; ++i) pattern.add(i, i - 2);
  pattern.compress();
  particles::BlockMatrix other(pattern);
  for (int i = 0; i < 40; ++i) other.add(i, i, (2.0 + i) * Mat3::Identity());
  expect_solved(given, other);
}

}  // namespace
}  // namespace loosefit::solver
