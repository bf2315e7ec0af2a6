#include "loosefit/fabric/membrane_energy.h"

#include <gtest/gtest.h>

#include "support/flat_garment.h"
#include "support/law_checker.h"

namespace loosefit {
namespace {

Material orthotropic() {
  Material m;
  m.stiffness_weft = 300;
  m.stiffness_warp = 700;
  m.poisson = 0.25;
  m.stiffness_shear = 60;
  m.damping = 0.05;
  return m;
}

VectorField shaken(const TriangleMesh& mesh, double amplitude) {
  std::mt19937 rng(11);
  std::uniform_real_distribution<double> u(-amplitude, amplitude);
  VectorField x = mesh.vertices;
  for (Vec3& p : x) p = Vec3(1.2 * p[0] + 0.1 * p[1], 0.9 * p[1], 0) + Vec3(u(rng), u(rng), u(rng));
  return x;
}

TEST(MembraneEnergy, ObeysTheLaws) {
  const TriangleMesh mesh = support::sheet(0.04, 0.04, 0.01, 0.2);
  const MembraneEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, orthotropic());
  const VectorField x = shaken(mesh, 0.002);
  support::expect_derivatives(energy, x);
  support::expect_no_net_force_or_torque(energy, x);
  support::expect_rigid_invariance(energy, x);
  EXPECT_LT(energy.value(mesh.vertices), 1e-25);
}

TEST(MembraneEnergy, ObeysTheLawsWithCompressiveSofteningAndViscosity) {
  const TriangleMesh mesh = support::sheet(0.03, 0.03, 0.01, 0.2);
  Material m = orthotropic();
  m.compression_factor = 0.1;
  MembraneEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, m, true);
  energy.begin_step(mesh.vertices, 0.01);
  const VectorField x = shaken(mesh, 0.002);
  support::expect_derivatives(energy, x, 1e-7, 1e-5);
  support::expect_no_net_force_or_torque(energy, x);
}

TEST(MembraneEnergy, ViscosityLeavesRigidMotionAlone) {
  const TriangleMesh mesh = support::sheet(0.03, 0.03, 0.01, 0.2);
  MembraneEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, orthotropic(), true);
  energy.begin_step(mesh.vertices, 0.001);
  VectorField moved = mesh.vertices;
  const Eigen::AngleAxisd turn(0.4, Vec3(1, 1, 0).normalized());
  for (Vec3& p : moved) p = turn * p + Vec3(0.1, 0, 0);
  for (const Vec3& f : support::gradient(energy, moved)) EXPECT_LT(f.norm(), 1e-10);
}

// validation.md 1.4 (a): homogeneous states on an irregular mesh against the closed form.
class PatchTest : public ::testing::TestWithParam<std::array<double, 3>> {};

TEST_P(PatchTest, EdgeForcesMatchTheClosedFormTo1e9) {
  const auto [lu, lv, shear] = GetParam();
  const double w = 0.05, l = 0.06;
  const TriangleMesh mesh = support::sheet(w, l, 0.01, 0.25);
  const Material m = orthotropic();
  const MembraneEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, m);
  const Eigen::AngleAxisd turn(0.7, Vec3(0.2, 1, 0.4).normalized());
  VectorField x = mesh.vertices;
  for (Vec3& p : x) p = turn * Vec3(lu * p[0] + shear * p[1], lv * p[1], 0);
  const VectorField g = support::gradient(energy, x);

  const double plate = 1 - m.poisson * m.poisson;
  const double cuu = m.stiffness_weft / plate, cvv = m.stiffness_warp / plate;
  const double cuv = m.poisson * std::sqrt(m.stiffness_weft * m.stiffness_warp) / plate;
  const double euu = (lu * lu - 1) / 2, evv = (lv * lv + shear * shear - 1) / 2, gamma = lu * shear;
  Mat2 f, s;
  f << lu, shear, 0, lv;
  s << cuu * euu + cuv * evv, m.stiffness_shear * gamma, m.stiffness_shear * gamma,
      cuv * euu + cvv * evv;
  const Mat2 p = f * s;
  // Nodes off the border are in balance; the border does the work of P under every affine motion.
  double inner = 0;
  Mat3 work = Mat3::Zero();  // Σ f_i X_iᵀ = A P in the rotated frame
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec3& q = mesh.vertices[i];
    if (q[0] > 1e-12 && q[0] < w - 1e-12 && q[1] > 1e-12 && q[1] < l - 1e-12)
      inner = std::max(inner, g[i].norm());
    work += g[i] * q.transpose();
  }
  Mat3 expected = Mat3::Zero();
  expected.topLeftCorner<2, 2>() = w * l * p;
  expected = turn.toRotationMatrix() * expected;
  EXPECT_LT(inner, 1e-9 * p.norm() * l);
  EXPECT_LT((work - expected).norm(), 1e-9 * expected.norm());
}

INSTANTIATE_TEST_SUITE_P(UpToHalf, PatchTest,
                         ::testing::Values(std::array{1.5, 1.0, 0.0}, std::array{1.0, 1.5, 0.0},
                                           std::array{1.25, 1.25, 0.0}, std::array{1.0, 1.0, 0.5},
                                           std::array{1.3, 0.9, 0.2}, std::array{0.8, 1.1, 0.1}));

}  // namespace
}  // namespace loosefit
