#include "loosefit/fabric/bending_energy.h"

#include <gtest/gtest.h>

#include "support/flat_garment.h"
#include "support/law_checker.h"

namespace loosefit {
namespace {

VectorField crumpled(const TriangleMesh& mesh) {
  std::mt19937 rng(4);
  std::uniform_real_distribution<double> u(-0.003, 0.003);
  VectorField x = mesh.vertices;
  for (Vec3& p : x) p += Vec3(u(rng), u(rng), u(rng) + 30 * p[0] * p[0] * p[0]);
  return x;
}

TEST(BendingEnergy, ObeysTheLaws) {
  const TriangleMesh mesh = support::sheet(0.03, 0.03, 0.01, 0.2);
  Material m;
  m.bending_weft = 2e-6;
  m.bending_warp = 9e-6;
  const BendingEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, m);
  const VectorField x = crumpled(mesh);
  support::expect_derivatives(energy, x, 1e-7, 1e-5);
  support::expect_no_net_force_or_torque(energy, x);
  support::expect_rigid_invariance(energy, x);
  EXPECT_EQ(energy.value(mesh.vertices), 0.0);
}

TEST(BendingEnergy, DihedralAngleOfAKnownFold) {
  const Vec3 x0(0, 0, 0), x1(1, 0, 0), x2(0.3, 1, 0);
  const double fold = 0.8;
  const Vec3 x3(0.4, -std::cos(fold), std::sin(fold));
  EXPECT_NEAR(std::abs(dihedral(x0, x1, x2, x3, nullptr).angle), fold, 1e-14);
}

// validation.md 2.4: a sheet rolled to curvature κ stores B κ²/2 per area, in whatever direction.
class CylinderTest : public ::testing::TestWithParam<double> {};

TEST_P(CylinderTest, EnergyIsHalfRigidityTimesCurvatureSquared) {
  const double angle = radians(GetParam()), kappa = 4.0;
  const TriangleMesh mesh = support::sheet(0.2, 0.2, 0.004);
  const Material m;
  const BendingEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, m);
  VectorField x = mesh.vertices;
  for (Vec3& p : x) {
    const double s = p[0] * std::cos(angle) + p[1] * std::sin(angle);
    const double t = -p[0] * std::sin(angle) + p[1] * std::cos(angle);
    p = Vec3(std::sin(kappa * s) / kappa, t, (1 - std::cos(kappa * s)) / kappa);
  }
  // Border triangles have fewer hinges and the zipped ends are not equilateral: 4 mm of 200 mm.
  const double expected = 0.5 * m.bending_warp * kappa * kappa * 0.2 * 0.2;
  EXPECT_NEAR(energy.value(x), expected, 0.05 * expected);
}

INSTANTIATE_TEST_SUITE_P(Directions, CylinderTest, ::testing::Values(0.0, 22.5, 45.0, 90.0, 135.0));

}  // namespace
}  // namespace loosefit
