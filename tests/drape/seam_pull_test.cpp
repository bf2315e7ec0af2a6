#include "loosefit/drape/seam_pull.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "support/block_matrices.h"

namespace loosefit::drape {
namespace {

constexpr double kStiffness = 120, kReach = 0.004;

TEST(SeamPull, NearItIsASpringOfLengthZeroAndFarAThreadOfConstantForce) {
  const SeamPull pull({{0, 1}}, kStiffness, kReach);
  for (const auto& [distance, force] :
       {std::pair(1e-6, kStiffness * 1e-6), std::pair(4.0, kStiffness * kReach)}) {
    const std::vector<Vec3> x = {Vec3(1, 2, 3), Vec3(1, 2 + distance, 3)};
    std::vector<Vec3> g(2, Vec3::Zero());
    pull.add_gradient(x, g);
    EXPECT_NEAR(g[1].y(), force, 1e-6 * force + 1e-9);
    EXPECT_EQ(g[0], -g[1]);
  }
  EXPECT_EQ(pull.value({Vec3(1, 2, 3), Vec3(1, 2, 3)}), 0);
}

TEST(SeamPull, GradientAndHessianAreThoseOfTheEnergyAndTheHessianIsPositive) {
  // A corner where four panels meet, and a seam of two.
  const SeamPull pull({{0, 2, 3, 5}, {1, 4}}, kStiffness, kReach);
  std::vector<Vec3> x = support::random_field(6);
  for (Vec3& p : x) p *= 2 * kReach;
  std::vector<Vec3> g(6, Vec3::Zero());
  pull.add_gradient(x, g);
  particles::BlockPattern pattern(6);
  pull.add_pattern(x, pattern);
  pattern.compress();
  particles::BlockMatrix h(pattern);
  pull.add_hessian(x, h, particles::HessianKind::exact);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(18, 18);
  const double step = 1e-7;
  for (int k = 0; k < 18; ++k) {
    std::vector<Vec3> unit(6, Vec3::Zero()), column(6, Vec3::Zero());
    unit[k / 3][k % 3] = 1;
    h.add_product(unit, column);
    for (int i = 0; i < 18; ++i) dense(i, k) = column[i / 3][i % 3];
    std::vector<Vec3> up = x, down = x, g_up(6, Vec3::Zero()), g_down(6, Vec3::Zero());
    up[k / 3][k % 3] += step, down[k / 3][k % 3] -= step;
    EXPECT_NEAR(g[k / 3][k % 3], (pull.value(up) - pull.value(down)) / (2 * step), 1e-6);
    pull.add_gradient(up, g_up);
    pull.add_gradient(down, g_down);
    for (int i = 0; i < 18; ++i)
      EXPECT_NEAR(dense(i, k), (g_up[i / 3][i % 3] - g_down[i / 3][i % 3]) / (2 * step), 1e-3);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(dense);
  EXPECT_GT(eigen.eigenvalues().minCoeff(), -1e-9 * kStiffness);
}

TEST(SeamPull, WidestGapIsThatOfAnyTwoPartners) {
  const std::vector<Vec3> x = {Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(3, 4, 0), Vec3(9, 9, 9)};
  EXPECT_EQ(widest_gap({{0, 1, 2}}, x), 5);
  EXPECT_EQ(widest_gap({}, x), 0);
}

}  // namespace
}  // namespace loosefit::drape
