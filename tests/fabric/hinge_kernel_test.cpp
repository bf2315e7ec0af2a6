#include "loosefit/fabric/hinge_kernel.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "loosefit/fabric/hinge_blocks.h"
#include "support/dihedral.h"

namespace loosefit::fabric {
namespace {

using support::Dihedral;
using support::dihedral;
using support::DihedralHessian;

using Matrix12 = Eigen::Matrix<double, 12, 12>;

/// Hinges of edge 10 mm and every fold angle between −π and π, turned at random.
struct Hinges {
  std::array<std::array<Vec3, 4>, particles::kTile> point;
  HingePoints rows;
};

Hinges random_hinges(unsigned seed) {
  std::mt19937 rng(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  Hinges h;
  for (int i = 0; i < particles::kTile; ++i) {
    const double fold = kPi * (2.0 * i / (particles::kTile - 1) - 1) * 0.999;
    const double r = 0.008 + 0.003 * u(rng), s = 0.008 + 0.003 * u(rng);
    std::array<Vec3, 4>& p = h.point[i];
    p = {Vec3(0, 0, 0), Vec3(0.01 + 0.003 * u(rng), 0, 0), Vec3(0.005 + 0.006 * u(rng), r, 0),
         Vec3(0.005 + 0.006 * u(rng), -s * std::cos(fold), s * std::sin(fold))};
    const Eigen::Quaterniond turn = Eigen::Quaterniond(u(rng), u(rng), u(rng), u(rng)).normalized();
    for (int a = 0; a < 4; ++a) {
      p[a] = turn * p[a] + Vec3(0.3, -0.1, 1.2);
      for (int c = 0; c < 3; ++c) h.rows[a][c][i] = p[a][c];
    }
  }
  return h;
}

Matrix12 dense(const HingeBlocks& blocks, int i) {
  Matrix12 m;
  int block = 0;
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b <= a; ++b, ++block)
      for (int q = 0; q < 3; ++q)
        for (int p = 0; p < 3; ++p) {
          m(3 * a + p, 3 * b + q) = blocks[9 * block + 3 * q + p][i];
          m(3 * b + q, 3 * a + p) = blocks[9 * block + 3 * q + p][i];
        }
  return m;
}

Matrix12 reference(const std::array<Vec3, 4>& x, double stiffness, double moment) {
  DihedralHessian second;
  const Dihedral d = dihedral(x[0], x[1], x[2], x[3], &second);
  Matrix12 m;
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b)
      m.block<3, 3>(3 * a, 3 * b) =
          stiffness * d.gradient[a] * d.gradient[b].transpose() + moment * second[a][b];
  return m;
}

double smallest(const Matrix12& m) {
  return Eigen::SelfAdjointEigenSolver<Matrix12>(m, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

TEST(HingeKernel, FindsTheAnglesAndGradientsOfTheScalarFormula) {
  for (unsigned seed : {1u, 2u, 3u}) {
    const Hinges h = random_hinges(seed);
    particles::TileRow angle, alone, one;
    HingeGradient gradient;
    hinge_angles(h.rows, angle, gradient);
    hinge_angles(h.rows, alone);
    one.fill(1);
    std::array<particles::TileRow, 12> row;
    hinge_forces(gradient, one, row);
    for (int i = 0; i < particles::kTile; ++i) {
      const auto& x = h.point[i];
      const Dihedral d = dihedral(x[0], x[1], x[2], x[3]);
      EXPECT_NEAR(angle[i], d.angle, 1e-13);  // the points themselves are rounded to 1e-16 m
      EXPECT_EQ(angle[i], alone[i]);
      for (int a = 0; a < 4; ++a)
        for (int c = 0; c < 3; ++c)
          EXPECT_NEAR(row[3 * a + c][i], d.gradient[a][c], 1e-11 * d.gradient[a].norm() + 1e-10);
    }
  }
}

TEST(HingeKernel, ExactBlocksAreTheSecondDerivatives) {
  const Hinges h = random_hinges(4);
  particles::TileRow stiffness, moment;
  for (int i = 0; i < particles::kTile; ++i) {
    stiffness[i] = i % 3;
    moment[i] = 1 - i % 4;
  }
  HingeBlocks blocks;
  hinge_blocks(h.rows, stiffness, moment, blocks);
  for (int i = 0; i < particles::kTile; ++i) {
    const Matrix12 expected = reference(h.point[i], stiffness[i], moment[i]);
    EXPECT_LT((dense(blocks, i) - expected).norm(), 1e-10 * expected.norm() + 1e-9) << i;
  }
}

// The positive part P of a symmetric matrix H has P ⪰ 0 and P − H ⪰ 0, and of all such it is no
// farther from H than H's own negative part allows: here within a small factor of the nearest one.
TEST(HingeKernel, DefiniteBlocksAreAPositivePart) {
  for (unsigned seed = 5; seed < 25; ++seed) {
    const Hinges h = random_hinges(seed);
    std::mt19937 rng(seed);
    std::uniform_real_distribution<double> u(-1, 1);
    particles::TileRow stiffness, moment;
    for (int i = 0; i < particles::kTile; ++i) {
      stiffness[i] = i % 4 ? std::pow(10, 2 * u(rng)) : 0;
      moment[i] = 3 * u(rng);
    }
    HingeBlocks blocks;
    hinge_definite_blocks(h.rows, stiffness, moment, blocks);
    for (int i = 0; i < particles::kTile; ++i) {
      const Matrix12 definite = dense(blocks, i);
      const Matrix12 exact = reference(h.point[i], stiffness[i], moment[i]);
      EXPECT_GT(smallest(definite), -1e-11 * definite.norm()) << seed << " " << i;
      EXPECT_GT(smallest(definite - exact), -1e-10 * definite.norm()) << seed << " " << i;
      const Eigen::SelfAdjointEigenSolver<Matrix12> eigen(exact);
      const double least_distance = eigen.eigenvalues().cwiseMin(0.0).norm();
      EXPECT_LT((definite - exact).norm(), 3 * least_distance) << seed << " " << i;
    }
  }
}

TEST(HingeKernel, DefiniteBlocksAreExactWithoutMoment) {
  const Hinges h = random_hinges(30);
  particles::TileRow stiffness, moment{};
  for (int i = 0; i < particles::kTile; ++i) stiffness[i] = i % 5;
  HingeBlocks blocks;
  hinge_definite_blocks(h.rows, stiffness, moment, blocks);
  for (int i = 0; i < particles::kTile; ++i) {
    const Matrix12 expected = reference(h.point[i], stiffness[i], 0);
    EXPECT_LE((dense(blocks, i) - expected).norm(), 1e-11 * expected.norm()) << i;
  }
}

}  // namespace
}  // namespace loosefit::fabric
