#include "loosefit/fabric/bending_energy.h"

#include <gtest/gtest.h>

#include <limits>

#include "loosefit/fabric/dihedral.h"
#include "support/flat_garment.h"
#include "support/law_checker.h"

namespace loosefit::fabric {
namespace {

particles::VectorField crumpled(const geometry::TriangleMesh& mesh) {
  std::mt19937 rng(4);
  std::uniform_real_distribution<double> u(-0.003, 0.003);
  particles::VectorField x = mesh.vertices;
  for (Vec3& p : x) p += Vec3(u(rng), u(rng), u(rng) + 30 * p[0] * p[0] * p[0]);
  return x;
}

struct Law {
  double poisson, hysteresis;
  bool viscous;
};
class BendingLaws : public ::testing::TestWithParam<Law> {};

TEST_P(BendingLaws, HaveAnEnergyWithItsDerivatives) {
  const geometry::TriangleMesh mesh = support::sheet(0.03, 0.03, 0.01, 0.2);
  Material m;
  m.bending_weft = 2e-6;
  m.bending_warp = 9e-6;
  m.bending_poisson = GetParam().poisson;
  m.bending_hysteresis_weft = GetParam().hysteresis;
  m.bending_hysteresis_warp = 2 * GetParam().hysteresis;
  m.damping = 0.003;
  BendingEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, m, GetParam().viscous);
  particles::VectorField x = crumpled(mesh);
  if (GetParam().viscous || GetParam().hysteresis > 0) {
    energy.begin_step(x, 0.01);  // something to remember
    for (Vec3& p : x) p[2] += 0.02 * p[1] * p[0] + 1e-4 * std::sin(300 * p[1]);
  }
  support::expect_derivatives(energy, x, 1e-7, 1e-5);
  support::expect_no_net_force_or_torque(energy, x);
  support::expect_rigid_invariance(energy, x);
}

INSTANTIATE_TEST_SUITE_P(Bending, BendingLaws,
                         ::testing::Values(Law{0, 0, false}, Law{0.3, 0, false},
                                           Law{-1.0 / 3, 0, false}, Law{0.15, 0, true},
                                           Law{0, 2e-4, false}, Law{0.3, 5e-5, false}));

TEST(BendingEnergy, FlatClothStoresNothing) {
  const geometry::TriangleMesh mesh = support::sheet(0.03, 0.03, 0.01, 0.2);
  EXPECT_EQ(
      BendingEnergy(mesh.triangles, support::flat_uv(mesh), {}, Material{}).value(mesh.vertices),
      0.0);
}

TEST(BendingEnergy, DihedralAngleOfAKnownFold) {
  const Vec3 x0(0, 0, 0), x1(1, 0, 0), x2(0.3, 1, 0);
  const double fold = 0.8;
  const Vec3 x3(0.4, -std::cos(fold), std::sin(fold));
  EXPECT_NEAR(std::abs(dihedral_angle(x0, x1, x2, x3)), fold, 1e-14);
}

// docs/theory/validation.md 2.2: energy per area of constant curvature, to which every mesh must be
// blind: cylinder B κ²/2 in any direction, sphere D (1 + ν) κ², twist w = k x y D (1 − ν) k².
struct Shape {
  const char* name;
  double uu, vv, uv;  ///< curvature tensor [1/m]
};
class ConstantCurvature : public ::testing::TestWithParam<std::tuple<Shape, double>> {};

TEST_P(ConstantCurvature, StoresTheEnergyOfThePlate) {
  const auto& [shape, poisson] = GetParam();
  const geometry::TriangleMesh mesh = support::sheet(0.1, 0.1, 0.01, 0.25);
  Material m;
  m.bending_weft = 3e-6;
  m.bending_warp = 8e-6;
  m.bending_poisson = poisson;
  particles::VectorField x = mesh.vertices;
  for (Vec3& p : x)
    p[2] = 0.5 * shape.uu * p[0] * p[0] + 0.5 * shape.vv * p[1] * p[1] + shape.uv * p[0] * p[1];
  const BendingEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, m);
  const Vec3 kappa(shape.uu, shape.vv, 2 * shape.uv);  // hollow towards the outside: negative
  int inner = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    bool far = true;  // from the border, where the moment-free condition holds instead
    for (int v : mesh.triangles[t])
      for (int c = 0; c < 2; ++c)
        far = far && mesh.vertices[v][c] > 0.012 && mesh.vertices[v][c] < 0.088;
    if (!far) continue;
    ++inner;
    EXPECT_LT((energy.curvature(static_cast<int>(t), x) + kappa).norm(), 1e-4 * kappa.norm());
  }
  EXPECT_GT(inner, 100);
  const Mat3 d = plate_rigidity(m);
  const double expected = 0.5 * kappa.dot(d * kappa);
  const double root = std::sqrt(m.bending_weft * m.bending_warp);
  EXPECT_NEAR(expected,
              0.5 * m.bending_weft * shape.uu * shape.uu +
                  0.5 * m.bending_warp * shape.vv * shape.vv +
                  poisson * root * shape.uu * shape.vv + (1 - poisson) * root * shape.uv * shape.uv,
              1e-12 * expected);
}

INSTANTIATE_TEST_SUITE_P(
    Validation24, ConstantCurvature,
    ::testing::Combine(::testing::Values(Shape{"weft", 0.04, 0, 0}, Shape{"warp", 0, 0.04, 0},
                                         Shape{"oblique", 0.01, 0.03, 0.0173205},
                                         Shape{"sphere", 0.04, 0.04, 0},
                                         Shape{"saddle", 0.04, -0.04, 0},
                                         Shape{"twist", 0, 0, 0.04}),
                       ::testing::Values(0.0, 0.3)));

// A constant moment leaves every inner vertex in balance, on an irregular mesh too: otherwise the
// sheet would escape some of the bending by wrinkling at the scale of its triangles.
TEST_P(ConstantCurvature, LeavesInnerVerticesInBalance) {
  const auto& [shape, poisson] = GetParam();
  const geometry::TriangleMesh mesh = support::sheet(0.1, 0.1, 0.01, 0.25);
  Material m;
  m.bending_weft = 3e-6;
  m.bending_warp = 8e-6;
  m.bending_poisson = poisson;
  particles::VectorField x = mesh.vertices;
  for (Vec3& p : x)
    p[2] = 0.5 * shape.uu * p[0] * p[0] + 0.5 * shape.vv * p[1] * p[1] + shape.uv * p[0] * p[1];
  const BendingEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, m);
  const particles::VectorField g = support::gradient(energy, x);
  double inside = 0, border = 0;
  for (std::size_t i = 0; i < g.size(); ++i) {
    bool far = true;  // no triangle that feels it touches the border
    for (int c = 0; c < 2; ++c)
      far = far && mesh.vertices[i][c] > 0.035 && mesh.vertices[i][c] < 0.065;
    double& largest = far ? inside : border;
    largest = std::max(largest, std::abs(g[i][2]));
  }
  EXPECT_GT(border, 0);
  EXPECT_LT(inside, 1e-4 * border);
}

// The tangent on the narrow stencil is no derivative, but near one: it vanishes for rigid motion
// and lies within a factor of the full one.
TEST(BendingEnergy, NearTangentLiesCloseToTheFullOne) {
  const geometry::TriangleMesh mesh = support::sheet(0.06, 0.06, 0.01, 0.25);
  BendingEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, Material{});
  energy.set_tangent(particles::BendingTangent::hinge);
  const Eigen::MatrixXd near =
      support::dense_hessian(energy, mesh.vertices, particles::HessianKind::exact);
  energy.set_tangent(particles::BendingTangent::plate);
  const Eigen::MatrixXd full =
      support::dense_hessian(energy, mesh.vertices, particles::HessianKind::exact);
  Eigen::VectorXd smooth(near.rows()), rigid(near.rows());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3& p = mesh.vertices[i];
    smooth.segment<3>(3 * i) = Vec3(0, 0, std::sin(40 * p[0]) * std::cos(50 * p[1]));
    rigid.segment<3>(3 * i) = Vec3(0, 0, 0.3 + 2 * p[0] - p[1]);
  }
  EXPECT_LT((near * rigid).norm(), 1e-9 * (near * smooth).norm());
  const double share = smooth.dot(near * smooth) / smooth.dot(full * smooth);
  EXPECT_GT(share, 0.85);
  EXPECT_LT(share, 1.15);
}

// A sheet rolled to curvature κ far beyond small deflections stores B κ²/2 per area.
class CylinderTest : public ::testing::TestWithParam<double> {};

TEST_P(CylinderTest, EnergyIsHalfRigidityTimesCurvatureSquared) {
  const double angle = radians(GetParam()), kappa = 12.0;
  const geometry::TriangleMesh mesh = support::sheet(0.2, 0.2, 0.004, 0.2);
  const Material m;
  const BendingEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, m);
  particles::VectorField x = mesh.vertices;
  for (Vec3& p : x) {
    const double s = p[0] * std::cos(angle) + p[1] * std::sin(angle);
    const double t = -p[0] * std::sin(angle) + p[1] * std::cos(angle);
    p = Vec3(std::sin(kappa * s) / kappa, t, (1 - std::cos(kappa * s)) / kappa);
  }
  // A border row of triangles may unbend across the border: at most 4 · 4 mm / 2 of 200 mm.
  const double expected = 0.5 * m.bending_warp * kappa * kappa * 0.2 * 0.2;
  EXPECT_NEAR(energy.value(x), 0.98 * expected, 0.025 * expected);
}

INSTANTIATE_TEST_SUITE_P(Directions, CylinderTest, ::testing::Values(0.0, 22.5, 45.0, 90.0, 135.0));

// Across a seam the two panels meet with their own pattern coordinates; bending must not notice.
TEST(BendingEnergy, IsTheSameAcrossASeam) {
  const geometry::TriangleMesh mesh = support::sheet(0.06, 0.04, 0.01, 0.2);
  const Material m;  // isotropic: the grain may turn
  auto uv = support::flat_uv(mesh);
  const BendingEnergy whole(mesh.triangles, uv, {}, m);
  const Eigen::Rotation2Dd turn(0.7);
  for (auto& corners : uv)
    if ((corners[0] + corners[1] + corners[2])[0] / 3 > 0.03)
      for (Vec2& p : corners) p = turn * Vec2(p[0], p[1]) + Vec2(0.5, -0.2);
  const BendingEnergy sewn(mesh.triangles, uv, {}, m);
  const particles::VectorField x = crumpled(mesh);
  EXPECT_NEAR(sewn.value(x), whole.value(x), 1e-12 * whole.value(x));
}

// docs/theory/validation.md 2.3: M = B κ ± HB. Bent to a tight curve and let go, a strip stops at
// κ_res = HB/B.
TEST(BendingFriction, ReleasedStripKeepsTheResidualCurvature) {
  const double rigidity = 1.15718e-5, hysteresis = 0.5 * 1.21602e-3;  // cotton broad
  const BendingFriction friction({hysteresis, hysteresis}, {rigidity, rigidity});
  Vec3 anchor = Vec3::Zero();
  const auto moment = [&](double kappa) {
    const Vec3 k(0, kappa, 0);
    const double m = rigidity * kappa + friction.respond(k, anchor).moment[1];
    anchor = friction.carried(friction.slide(k), anchor);
    return m;
  };
  double kappa = 0, loading = 0;
  for (; kappa < 250; kappa += 0.5) loading = moment(kappa);
  EXPECT_NEAR(loading, rigidity * (kappa - 0.5) + hysteresis, 1e-3 * loading);
  double last = 1;
  while (last > 0) last = moment(kappa -= 0.05);
  EXPECT_NEAR(kappa, 52.54, 0.1);
  // The other way round the loop is as wide.
  while (kappa > -250) last = moment(kappa -= 0.5);
  EXPECT_NEAR(last, rigidity * kappa - hysteresis, 1e-3 * std::abs(last));
}

// Weft and warp may have loops of very different width; each keeps its own residual curvature.
TEST(BendingFriction, UnequalDirectionsKeepTheirOwn) {
  const Vec2 rigidity(1e-5, 1e-5);
  for (double share : {1.0, 0.3, 0.1}) {
    const Vec2 hysteresis(share * 6e-4, 6e-4);
    const BendingFriction friction(hysteresis, rigidity);
    for (int direction : {0, 1}) {
      const double residual = hysteresis[direction] / rigidity[direction];
      Vec3 anchor = Vec3::Zero(), k = Vec3::Zero();
      for (int step = 0; step <= 100; ++step) {
        k[direction] = 1.5 * residual * step / 100;
        anchor = friction.carried(friction.slide(k), anchor);
      }
      double moment = 1;
      for (; moment > 0 && k[direction] > 0; k[direction] -= 1e-3 * residual) {
        moment = rigidity[direction] * k[direction] + friction.respond(k, anchor).moment[direction];
        anchor = friction.carried(friction.slide(k), anchor);
      }
      EXPECT_NEAR(k[direction], residual, 0.01 * residual) << share << " " << direction;
    }
  }
}

// Iterates of one static balance are no steps of history.
TEST(BendingFriction, StaticIteratesLeaveNoTrace) {
  const geometry::TriangleMesh mesh = support::sheet(0.03, 0.03, 0.01, 0.2);
  Material m;
  m.bending_hysteresis_weft = m.bending_hysteresis_warp = 2e-4;
  BendingEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, m);
  energy.begin_step(mesh.vertices, 0.1);
  const particles::VectorField x = crumpled(mesh);
  const double once = energy.value(x);
  particles::VectorField overshoot = x;
  for (Vec3& p : overshoot) p[2] *= 3;
  energy.begin_step(overshoot, std::numeric_limits<double>::infinity());
  energy.begin_step(x, std::numeric_limits<double>::infinity());
  EXPECT_EQ(energy.value(x), once);
}

}  // namespace
}  // namespace loosefit::fabric
