#include "loosefit/fabric/band_energy.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "support/block_matrices.h"

namespace loosefit::fabric {
namespace {

constexpr double kStiffness = 40, kLength = 0.03, kPreStretch = 0.25;

/// Two triangles of the unit square, a band along u over both.
BandEnergy band(double pre_stretch = kPreStretch) {
  BandPart part;
  part.triangles = {{0, Vec3(-1, 1, 0), 0.4}, {1, Vec3(0, 1, -1), 0.6}};
  part.length = kLength;
  part.stiffness = kStiffness;
  part.pre_stretch = pre_stretch;
  return BandEnergy({Triangle{0, 1, 2}, Triangle{0, 3, 2}}, {part});
}

std::vector<Vec3> square(double stretch) {
  return {Vec3(0, 0, 0), Vec3(stretch, 0, 0), Vec3(0, 1, 0), Vec3(stretch, 1, 0)};
}

TEST(BandLaw, IsOfOnePieceAndNeverPushes) {
  EXPECT_EQ(band_law(-0.1).force, 0);
  EXPECT_EQ(band_law(-0.1).energy, 0);
  EXPECT_NEAR(band_law(0.5).force, 0.5 - kBandSlackElongation / 2, 1e-15);
  for (const double e : {1e-4, kBandSlackElongation, 0.0019, 0.1}) {
    const double step = 1e-7;
    EXPECT_NEAR(band_law(e).force,
                (band_law(e + step).energy - band_law(e - step).energy) / (2 * step), 1e-7);
    EXPECT_NEAR(band_law(e).tangent,
                (band_law(e + step).force - band_law(e - step).force) / (2 * step), 1e-4);
  }
}

TEST(BandEnergy, PullsByItsElongationAgainstItsOwnLength) {
  const BandEnergy energy = band();
  const double e = 1.25 * 1.1 - 1;
  const double force = kStiffness * kLength * band_law(e).force;
  std::vector<Vec3> g(4, Vec3::Zero());
  energy.add_gradient(square(1.1), g);
  // A unit square is pulled at both sides by the force times its length over its width of one.
  EXPECT_NEAR(g[1].x() + g[3].x(), force, 1e-12);
  EXPECT_NEAR(g[0].x() + g[2].x(), -force, 1e-12);
  EXPECT_NEAR(energy.value(square(1.1)), kStiffness * kLength / 1.25 * band_law(e).energy, 1e-12);
  EXPECT_EQ(energy.value(square(0.79)), 0) << "slack below its own length, 1/1.25";
}

TEST(BandEnergy, StretchAcrossItAndShearAlongItCostNothing) {
  const BandEnergy energy = band(0);
  std::vector<Vec3> x = square(1.0);
  x[2] = Vec3(0.3, 1.4, 0), x[3] = x[2] + Vec3(1, 0, 0);
  EXPECT_NEAR(energy.value(x), 0, 1e-15);
}

TEST(BandEnergy, GradientAndHessianAreThoseOfTheEnergyAndTheHessianIsPositive) {
  for (const double stretch : {0.802, 0.85, 1.3}) {  // taking up slack; taut
    const BandEnergy energy = band();
    std::vector<Vec3> x = square(stretch);
    const std::vector<Vec3> shake = support::random_field(4);
    for (int i = 0; i < 4; ++i) x[i] += (stretch < 0.81 ? 1e-4 : 0.1) * shake[i];
    std::vector<Vec3> g(4, Vec3::Zero());
    energy.add_gradient(x, g);
    particles::BlockPattern pattern(4);
    energy.add_pattern(x, pattern);
    pattern.compress();
    particles::BlockMatrix h(pattern);
    energy.add_hessian(x, h, particles::HessianKind::exact);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(12, 12);
    const double step = 1e-6;
    for (int k = 0; k < 12; ++k) {
      std::vector<Vec3> unit(4, Vec3::Zero()), column(4, Vec3::Zero());
      unit[k / 3][k % 3] = 1;
      h.add_product(unit, column);
      for (int i = 0; i < 12; ++i) dense(i, k) = column[i / 3][i % 3];
      std::vector<Vec3> up = x, down = x, g_up(4, Vec3::Zero()), g_down(4, Vec3::Zero());
      up[k / 3][k % 3] += step, down[k / 3][k % 3] -= step;
      EXPECT_NEAR(g[k / 3][k % 3], (energy.value(up) - energy.value(down)) / (2 * step), 1e-7);
      energy.add_gradient(up, g_up);
      energy.add_gradient(down, g_down);
      for (int i = 0; i < 12; ++i)
        EXPECT_NEAR(dense(i, k), (g_up[i / 3][i % 3] - g_down[i / 3][i % 3]) / (2 * step), 1e-4);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(dense);
    EXPECT_GT(eigen.eigenvalues().minCoeff(), -1e-9 * kStiffness);
    EXPECT_GT(dense.norm(), 0.01);
  }
}

}  // namespace
}  // namespace loosefit::fabric
