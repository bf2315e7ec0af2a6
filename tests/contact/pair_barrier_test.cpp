#include "loosefit/contact/pair_barrier.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

namespace loosefit::contact {
namespace {

/// Two crossing edges, or a point over a triangle, `gap` apart and a little askew.
BarrierPair pair_of(PairKind kind) {
  BarrierPair pair;
  pair.kind = kind;
  pair.reach = 5e-4;
  pair.scale = 0.1;
  pair.parallel_threshold = 1e-3;
  return pair;
}

PairPoints points_of(PairKind kind, double gap, std::mt19937& rng) {
  std::uniform_real_distribution<double> u(-0.2, 0.2);
  const auto at = [&](double x, double y, double z) { return Vec3(x + u(rng), y + u(rng), z); };
  if (kind == PairKind::edge_edge)
    return {at(-1, 0, gap), at(1, 0, gap), at(0, -1, 0), at(0, 1, 0)};
  return {at(0, 0, gap), at(-1, -1, 0), at(2, -1, 0), at(-1, 2, 0)};
}

double least_eigenvalue(const PairMatrix& h) {
  return Eigen::SelfAdjointEigenSolver<PairMatrix>(h, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

TEST(PairBarrier, DefiniteMatrixHasNoNegativeEigenvalue) {
  std::mt19937 rng(5);
  for (int i = 0; i < 60; ++i) {
    const BarrierPair pair = pair_of(i % 2 ? PairKind::edge_edge : PairKind::point_triangle);
    const double gap = pair.reach * (i % 3 == 0 ? 0.9 : i % 3 == 1 ? 0.1 : 1e-4);
    const PairPoints x = points_of(pair.kind, gap, rng);
    const Barrier b = evaluate_barrier(pair, x);
    ASSERT_TRUE(b.active);
    const PairMatrix h = barrier_hessian(pair, x, b, particles::HessianKind::projected);
    EXPECT_GT(least_eigenvalue(h), -1e-9 * h.norm()) << i;
  }
}

// An edge that turns about the other's direction comes nearer on the bend: the definite matrix of
// what is pressed hard must resist as the exact one does.
TEST(PairBarrier, DefiniteMatrixResistsWhatTheExactOneDoes) {
  std::mt19937 rng(6);
  std::normal_distribution<double> n;
  for (int i = 0; i < 60; ++i) {
    const BarrierPair pair = pair_of(i % 2 ? PairKind::edge_edge : PairKind::point_triangle);
    const PairPoints x = points_of(pair.kind, 0.01 * pair.reach, rng);
    const Barrier b = evaluate_barrier(pair, x);
    const PairMatrix exact = barrier_hessian(pair, x, b, particles::HessianKind::exact);
    const PairMatrix definite = barrier_hessian(pair, x, b, particles::HessianKind::projected);
    Eigen::Matrix<double, 12, 1> u;
    for (int k = 0; k < 12; ++k) u[k] = n(rng);
    EXPECT_GE(u.dot(definite * u), u.dot(exact * u) - 1e-9 * exact.norm()) << i;
  }
}

}  // namespace
}  // namespace loosefit::contact
