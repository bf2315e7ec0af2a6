#include "loosefit/solver/linear/newton_system.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "support/law_checker.h"

namespace loosefit::solver {
namespace {

/// A chain of springs of stiffness `stiff`, the first particle tied to its place by `soft` [N/m].
particles::BlockMatrix chain(int n, double stiff, double soft) {
  particles::BlockPattern pattern(n);
  for (int i = 1; i < n; ++i) pattern.add(i, i - 1);
  pattern.compress();
  particles::BlockMatrix m(pattern);
  m.add(0, 0, soft * Mat3::Identity());
  for (int i = 1; i < n; ++i) {
    m.add(i, i, stiff * Mat3::Identity());
    m.add(i - 1, i - 1, stiff * Mat3::Identity());
    m.add(i, i - 1, -stiff * Mat3::Identity());
  }
  return m;
}

std::vector<Vec3> wave(int n) {
  std::vector<Vec3> g(n);
  for (int i = 0; i < n; ++i) g[i] = Vec3(std::sin(0.3 * i), std::cos(0.7 * i), 1);
  return g;
}

double relative_residual(const particles::BlockMatrix& m, const std::vector<Vec3>& g,
                         const std::vector<Vec3>& dx) {
  Eigen::VectorXd x(3 * dx.size()), b(3 * g.size());
  for (std::size_t i = 0; i < dx.size(); ++i) {
    x.segment<3>(3 * static_cast<long>(i)) = dx[i];
    b.segment<3>(3 * static_cast<long>(i)) = -g[i];
  }
  return (support::dense(m) * x - b).norm() / b.norm();
}

/// Factorises without shift or held particles, and solves to the accuracy that is promised.
void expect_solved(NewtonSystem& system, const particles::BlockMatrix& m) {
  const std::vector<double> shift(m.particles(), 0.0);
  const std::vector<char> held;
  const auto g = wave(m.particles());
  ASSERT_TRUE(system.factorise(m, shift, held));
  std::vector<Vec3> dx;
  system.solve(g, dx);
  EXPECT_LT(relative_residual(m, g, dx), 1.01 * PrecisionTuning{}.accuracy);
}

TEST(NewtonSystem, SolvesToItsAccuracyInSinglePrecision) {
  NewtonSystem system;
  expect_solved(system, chain(60, 100, 1));
  EXPECT_FALSE(system.in_double());
}

TEST(NewtonSystem, TakesDoublePrecisionWhereSingleBreaksDown) {
  // A soft tie nine orders below the springs is lost in single precision.
  const particles::BlockMatrix m = chain(60, 1e6, 1e-3);
  NewtonSystem system;
  for (int k = 0; k < 3; ++k) expect_solved(system, m);
  EXPECT_TRUE(system.in_double());
}

TEST(NewtonSystem, GoesBackToSinglePrecisionAfterOneBreakdown) {
  NewtonSystem system;
  expect_solved(system, chain(60, 1e6, 1e-3));
  for (int k = 0; k < 3; ++k) expect_solved(system, chain(60, 100, 1));
  EXPECT_FALSE(system.in_double());
}

TEST(NewtonSystem, RefusesIndefiniteMatricesAndLeavesHeldParticlesAlone) {
  const std::vector<double> shift(20, 0.0);
  std::vector<char> held(20, 0);
  held[0] = held[7] = 1;
  NewtonSystem system;
  EXPECT_FALSE(system.factorise(chain(20, 100, -300), shift, {}));
  EXPECT_FALSE(system.in_double()) << "no matter of precision";
  const particles::BlockMatrix m = chain(20, 100, 1);
  ASSERT_TRUE(system.factorise(m, shift, held));
  std::vector<Vec3> dx;
  system.solve(wave(20), dx);
  EXPECT_TRUE(dx[0].isZero() && dx[7].isZero());
  EXPECT_GT(dx[3].norm(), 0);
}

}  // namespace
}  // namespace loosefit::solver
