#include "loosefit/fabric/membrane_energy.h"

#include <gtest/gtest.h>

#include <functional>

#include "support/flat_garment.h"
#include "support/law_checker.h"
#include "support/wool_sample.h"

namespace loosefit::fabric {
namespace {

Material orthotropic() {
  Material m;
  m.stiffness_weft = 300;
  m.stiffness_warp = 700;
  m.poisson = 0.25;
  m.stiffness_shear = 60;
  m.damping = 0.05;
  m.bending_warp = m.bending_weft = 1;  // too stiff to buckle
  return m;
}

/// The same where it buckles long before the mesh could show it.
Material limp(Material m) {
  m.bending_warp = 2e-6;
  m.bending_weft = 6e-6;
  return m;
}

particles::VectorField shaken(const geometry::TriangleMesh& mesh, double amplitude) {
  std::mt19937 rng(11);
  std::uniform_real_distribution<double> u(-amplitude, amplitude);
  particles::VectorField x = mesh.vertices;
  for (Vec3& p : x) p = Vec3(1.2 * p[0] + 0.1 * p[1], 0.9 * p[1], 0) + Vec3(u(rng), u(rng), u(rng));
  return x;
}

TEST(MembraneEnergy, ObeysTheLaws) {
  const geometry::TriangleMesh mesh = support::sheet(0.04, 0.04, 0.01, 0.2);
  const MembraneEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, orthotropic());
  const particles::VectorField x = shaken(mesh, 0.002);
  support::expect_derivatives(energy, x);
  support::expect_no_net_force_or_torque(energy, x);
  support::expect_rigid_invariance(energy, x);
  EXPECT_LT(energy.value(mesh.vertices), 1e-25);
}

TEST(MembraneEnergy, ObeysTheLawsWithCrimpAndViscosity) {
  const geometry::TriangleMesh mesh = support::sheet(0.03, 0.03, 0.01, 0.2);
  const Material m = limp(orthotropic());
  MembraneEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, m, true);
  energy.begin_step(mesh.vertices, 0.01);
  const particles::VectorField x = shaken(mesh, 0.002);
  support::expect_derivatives(energy, x, 1e-7, 1e-5);
  support::expect_no_net_force_or_torque(energy, x);
}

TEST(MembraneEnergy, ViscosityLeavesRigidMotionAlone) {
  const geometry::TriangleMesh mesh = support::sheet(0.03, 0.03, 0.01, 0.2);
  MembraneEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, orthotropic(), true);
  energy.begin_step(mesh.vertices, 0.001);
  particles::VectorField moved = mesh.vertices;
  const Eigen::AngleAxisd turn(0.4, Vec3(1, 1, 0).normalized());
  for (Vec3& p : moved) p = turn * p + Vec3(0.1, 0, 0);
  for (const Vec3& f : support::gradient(energy, moved)) EXPECT_LT(f.norm(), 1e-10);
}

Material with_curves() {
  Material m = support::wool_sample();
  m.poisson = 0.3;
  m.damping = 0.05;
  return m;
}

// Weft force peaks in relation to the width: the tangent of S turns negative while f still rises.
Material yielding() {
  Material m = orthotropic();
  m.curve_weft = {{0.05, 40}, {0.1, 50}, {0.6, 52}};
  m.curve_shear = {{0.02, 5}, {0.5, 6}};
  return m;
}

TEST(MembraneEnergyWithCurves, ObeysTheLaws) {
  const geometry::TriangleMesh mesh = support::sheet(0.03, 0.03, 0.01, 0.2);
  for (const Material& m : {with_curves(), yielding()}) {
    const MembraneEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, m);
    const particles::VectorField x = shaken(mesh, 0.002);
    support::expect_derivatives(energy, x, 1e-8, 1e-5);
    support::expect_no_net_force_or_torque(energy, x);
    support::expect_rigid_invariance(energy, x);
    EXPECT_LT(energy.value(mesh.vertices), 1e-25);
  }
}

TEST(MembraneEnergyWithCurves, ObeysTheLawsWithCrimpAndViscosity) {
  const geometry::TriangleMesh mesh = support::sheet(0.03, 0.03, 0.01, 0.2);
  for (const Material& m : {limp(with_curves()), limp(yielding())}) {
    MembraneEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, m, true);
    energy.begin_step(shaken(mesh, 0.0005), 0.01);
    const particles::VectorField x = shaken(mesh, 0.002);
    support::expect_derivatives(energy, x, 1e-8, 1e-5);
    support::expect_no_net_force_or_torque(energy, x);
  }
}

// The stress has no jump where a strain changes its sign or a yarn buckles.
TEST(MembraneEnergy, BucklingHasNoJumpAndATensileStripIsAsBefore) {
  const geometry::TriangleMesh mesh = support::sheet(0.02, 0.02, 0.01);
  const Material m = limp(orthotropic());
  const MembraneEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, m);
  const auto stress = [&](double lu) {
    particles::VectorField x = mesh.vertices;
    for (Vec3& p : x) p = Vec3(lu * p[0], 1.1 * p[1], 0);
    return energy.state(0, x).stress;
  };
  for (double lu = 0.8; lu < 1.1; lu += 1e-3)
    EXPECT_LT((stress(lu + 1e-9) - stress(lu - 1e-9)).norm(), 1e-5) << lu;
  // A strip pulled along the warp with free width still shows K_v and ν.
  const double evv = 0.105;
  const double euu = -m.poisson * std::sqrt(m.stiffness_warp / m.stiffness_weft) * evv;
  const Vec3 s = stress(std::sqrt(1 + 2 * euu));
  EXPECT_NEAR(s[0], 0, 1e-9);
  EXPECT_NEAR(s[1], m.stiffness_warp * evv, 1e-9);
}

// docs/theory/validation.md 1.3 (a): homogeneous states on an irregular mesh against the closed
// form.
using State2d = std::array<double, 3>;  // λ_u, λ_v, shear k: F = [[λ_u, k], [0, λ_v]]
class PatchTest : public ::testing::TestWithParam<State2d> {};

void expect_closed_form(const Material& m, const State2d& state,
                        const std::function<Vec3(double, double, double)>& law) {
  const auto [lu, lv, shear] = state;
  const double w = 0.05, l = 0.06;
  const geometry::TriangleMesh mesh = support::sheet(w, l, 0.01, 0.25);
  const MembraneEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, m);
  const Eigen::AngleAxisd turn(0.7, Vec3(0.2, 1, 0.4).normalized());
  particles::VectorField x = mesh.vertices;
  for (Vec3& p : x) p = turn * Vec3(lu * p[0] + shear * p[1], lv * p[1], 0);
  const particles::VectorField g = support::gradient(energy, x);

  const Vec3 stress =
      law((lu * lu - 1) / 2, (lv * lv + shear * shear - 1) / 2, lu * shear);  // E_uu, E_vv, γ
  Mat2 f, s;
  f << lu, shear, 0, lv;
  s << stress[0], stress[2], stress[2], stress[1];
  const Mat2 p = f * s;
  // Nodes off the border are in balance; the border does the work of P under every affine motion.
  double inner = 0;
  Mat3 work = Mat3::Zero();  // Σ f_i X_iᵀ = A P in the rotated frame
  Vec3 right = Vec3::Zero();
  double next_below = 1, next_above = 1;  // border edge at the corners of the side x = w
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec3& q = mesh.vertices[i];
    if (q[0] > 1e-12 && q[0] < w - 1e-12 && q[1] > 1e-12 && q[1] < l - 1e-12)
      inner = std::max(inner, g[i].norm());
    work += g[i] * q.transpose();
    if (q[0] > w - 1e-12)
      right += g[i];
    else if (q[1] < 1e-12)
      next_below = std::min(next_below, w - q[0]);
    else if (q[1] > l - 1e-12)
      next_above = std::min(next_above, w - q[0]);
  }
  Mat3 expected = Mat3::Zero();
  expected.topLeftCorner<2, 2>() = w * l * p;
  expected = turn.toRotationMatrix() * expected;
  EXPECT_LT(inner, 1e-9 * p.norm() * l);
  EXPECT_LT((work - expected).norm(), 1e-9 * expected.norm());
  // Reaction of the side x = w: its corners also carry half of the next edge of y = 0 and y = l.
  const Vec2 side = p * Vec2(l, (next_above - next_below) / 2);
  const Vec3 reaction = turn * Vec3(side[0], side[1], 0);
  EXPECT_LT((right - reaction).norm(), 1e-9 * p.norm() * l);
}

TEST_P(PatchTest, EdgeForcesMatchTheClosedFormTo1e9) {
  const Material m = orthotropic();
  const double plate = 1 - m.poisson * m.poisson;
  const double cuu = m.stiffness_weft / plate, cvv = m.stiffness_warp / plate;
  const double cuv = m.poisson * std::sqrt(m.stiffness_weft * m.stiffness_warp) / plate;
  expect_closed_form(m, GetParam(), [&](double euu, double evv, double gamma) {
    return Vec3(cuu * euu + cuv * evv, cuv * euu + cvv * evv, m.stiffness_shear * gamma);
  });
}

// The engineering law f = C (λ − 1), entered as measured curves of two yarns that do not see each
// other.
TEST_P(PatchTest, MeasuredForcesMatchTheClosedFormTo1e9) {
  Material m = orthotropic();
  m.poisson = 0;
  const double cu = 300, cv = 700;
  m.curve_weft = {{0.2, 0.2 * cu}, {0.6, 0.6 * cu}};
  m.curve_warp = {{0.3, 0.3 * cv}, {0.6, 0.6 * cv}};
  const auto engineering = [](double c, double e) {
    const double stretch = std::sqrt(1 + 2 * e);
    return e > 0 ? c * (stretch - 1) / stretch : c * e;
  };
  expect_closed_form(m, GetParam(), [&](double euu, double evv, double gamma) {
    return Vec3(engineering(cu, euu), engineering(cv, evv), m.stiffness_shear * gamma);
  });
}

// What any coupling of two measured curves has to keep: stress from an energy, hence a symmetric
// tangent, that is positive definite wherever it was measured, and pulled yarns that draw the
// others in, by no more than in the linear law.
TEST(MembraneEnergyWithCurves, CouplingIsSymmetricStableAndBelowThatOfTheLinearLaw) {
  const geometry::TriangleMesh mesh = support::sheet(0.02, 0.02, 0.01);
  Material m = orthotropic();
  const double cu = 300, cv = 700;
  m.curve_weft = {{0.2, 0.2 * cu}, {0.6, 0.6 * cu}};
  m.curve_warp = {{0.3, 0.3 * cv}, {0.6, 0.6 * cv}};
  const MembraneEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, m);
  const auto stress = [&](double euu, double evv) {
    particles::VectorField x = mesh.vertices;
    for (Vec3& p : x) p = Vec3(std::sqrt(1 + 2 * euu) * p[0], std::sqrt(1 + 2 * evv) * p[1], 0);
    return energy.state(0, x).stress;
  };
  const double h = 1e-6, most = m.poisson * std::sqrt(cu * cv) / (1 - m.poisson * m.poisson);
  for (double lu : {0.95, 1.05, 1.3, 1.55})
    for (double lv : {0.95, 1.1, 1.55}) {
      const double euu = (lu * lu - 1) / 2, evv = (lv * lv - 1) / 2;
      const Vec3 du = (stress(euu + h, evv) - stress(euu - h, evv)) / (2 * h);
      const Vec3 dv = (stress(euu, evv + h) - stress(euu, evv - h)) / (2 * h);
      EXPECT_NEAR(du[1], dv[0], 1e-4) << lu << " " << lv;
      EXPECT_GT(du[0] * dv[1] - du[1] * dv[0], 0) << lu << " " << lv;
      EXPECT_GT(du[1], 0);
      EXPECT_LE(du[1], most);
    }
}

INSTANTIATE_TEST_SUITE_P(UpToHalf, PatchTest,
                         ::testing::Values(std::array{1.5, 1.0, 0.0}, std::array{1.0, 1.5, 0.0},
                                           std::array{1.25, 1.25, 0.0}, std::array{1.0, 1.0, 0.5},
                                           std::array{1.3, 0.9, 0.2}, std::array{0.8, 1.1, 0.1}));

// The wool sample of docs/theory/materials.md 4 at its own measured strains, on the same patch.
TEST(WoolPatch, ShowsTheMeasuredStress) {
  const Material m = support::wool_sample();
  for (std::size_t i = 0; i < 7; ++i) {
    const CurvePoint u = support::wool_weft_green()[i], v = support::wool_warp_green()[6 - i],
                     s = support::wool_shear()[i];
    const double lu = std::sqrt(1 + 2 * u.strain), k = s.strain / lu;
    const double lv = std::sqrt(1 + 2 * v.strain - k * k);
    expect_closed_form(m, {lu, lv, k},
                       [&](double, double, double) { return Vec3(u.force, v.force, s.force); });
  }
}

// docs/theory/validation.md 6.3: an orthotropic strip cut at an angle, from the compliance at small
// strain.
TEST(OffAxisStrip, HasTheModulusOfTheCompliance) {
  Material m;
  m.stiffness_weft = 2000;
  m.stiffness_warp = 1000;
  m.poisson = 0.2 * std::sqrt(0.5);  // geometric mean of ν12 = 0.2 and ν21 = ν12 K2/K1
  m.stiffness_shear = 50;
  const geometry::TriangleMesh mesh = support::sheet(0.02, 0.02, 0.01);
  const MembraneEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, m);
  Mat3 stiffness;
  for (int i = 0; i < 3; ++i) {
    Vec3 e = Vec3::Zero();
    e[i] = 1e-4;
    const double lu = std::sqrt(1 + 2 * e[0]), k = e[2] / lu;
    const double lv = std::sqrt(1 + 2 * e[1] - k * k);
    particles::VectorField x = mesh.vertices;
    for (Vec3& p : x) p = Vec3(lu * p[0] + k * p[1], lv * p[1], 0);
    stiffness.col(i) = energy.state(0, x).stress / 1e-4;
  }
  const double expected[] = {2000, 596.216, 246.533, 187.793, 232.221, 473.876, 1000};
  for (int i = 0; i < 7; ++i) {
    const double c = std::cos(kPi * i / 12), s = std::sin(kPi * i / 12);
    const Vec3 pull(c * c, s * s, s * c);
    EXPECT_NEAR(1 / pull.dot(stiffness.inverse() * pull), expected[i], 1e-3) << 15 * i;
  }
}

// docs/theory/validation.md 6.4: picture frame with yarns that do not stretch.
TEST(PictureFrame, PullsAlongItsDiagonalAsDerived) {
  const double side = 0.2, g = 30, expected[] = {1.596267, 3.361998, 5.196152};
  const geometry::TriangleMesh mesh = support::sheet(side, side, 0.02, 0.25);
  Material plain = orthotropic(), curved = orthotropic();
  plain.stiffness_shear = g;
  curved.curve_shear = {{0.2, 0.2 * g}, {0.5, 0.5 * g}};
  for (const Material& m : {plain, curved}) {
    const MembraneEnergy energy(mesh.triangles, support::flat_uv(mesh), {}, m);
    for (int i = 0; i < 3; ++i) {
      // Both yarn directions turn by γ/2 towards the long diagonal.
      const double gamma = kPi * (i + 1) / 18, c = std::cos(gamma / 2), s = std::sin(gamma / 2);
      particles::VectorField x = mesh.vertices;
      for (Vec3& p : x) p = Vec3(c * p[0] + s * p[1], s * p[0] + c * p[1], 0);
      EXPECT_NEAR(energy.value(x), g * side * side * std::pow(std::sin(gamma), 2) / 2, 1e-12);
      double power = 0;  // of the forces, as γ grows
      const particles::VectorField force = support::gradient(energy, x);
      for (std::size_t k = 0; k < x.size(); ++k) {
        const Vec3& p = mesh.vertices[k];
        power += force[k].dot(Vec3(-s * p[0] + c * p[1], c * p[0] - s * p[1], 0) / 2);
      }
      const double diagonal_rate = std::sqrt(2.0) * side * (c - s) / 2;
      EXPECT_NEAR(power / diagonal_rate, expected[i], 1e-6) << "γ = " << 10 * (i + 1) << "°";
    }
  }
}

}  // namespace
}  // namespace loosefit::fabric
