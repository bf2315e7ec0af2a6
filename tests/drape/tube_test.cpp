#include <gtest/gtest.h>

#include "loosefit/geometry/exact_intersection.h"
#include "loosefit/solver/quasi_static.h"
#include "support/cloth_scene.h"

namespace loosefit::drape {
namespace {

using support::ClothScene;
using support::RolledSheet;

constexpr double kRadius = 0.05, kStiffness = 200, kPoisson = 0.3;

class TightTube : public ::testing::TestWithParam<double> {};

// docs/theory/validation.md 6.2, axially free, no friction: with rest girth C0 < C the hoop stretch
// is λ = C/C0, E = (λ² − 1)/2, λ_a = √(1 − 2νE), and the cloth presses with 2π λ K E per rest
// length.
TEST_P(TightTube, HasTheStrainAndPressureOfTheClosedForm) {
  const double stretch = GetParam(), girth = 2 * kPi * kRadius / stretch, height = 0.05;
  const RolledSheet tube = support::rolled_sheet(girth, height, girth / 90, 0.15);
  fabric::Material m;
  m.stiffness_warp = m.stiffness_weft = kStiffness;
  m.poisson = kPoisson;
  m.stiffness_shear = kStiffness / (2 * (1 + kPoisson));
  m.bending_warp = m.bending_weft = 1e-7;  // under 1 mPa; less, and yarns buckle at round-off
  ClothScene::Contact c;
  c.offset = 5e-5;
  c.stiffness = 2e8;
  c.spacing = 0.003;
  particles::VectorField start;
  for (const Vec2& p : tube.place) {
    const double a = 2 * kPi * p[0] / girth, r = 1.01 * kRadius;
    start.emplace_back(r * std::cos(a), r * std::sin(a), p[1]);
  }
  ClothScene scene(tube.mesh, tube.same, start, support::cylinder(kRadius, -0.05, 0.1, 20, 240), m,
                   c, 0.0);
  solver::SettleOptions options;
  options.tolerance = 1e-6;  // [N]: nothing has weight here
  const auto outcome = solver::make_quasi_static(scene.system)->settle(scene.x, options);
  EXPECT_EQ(outcome.reason, solver::SettleOutcome::Reason::converged)
      << outcome.text() << " " << outcome.residual;

  // No gap: the middles of the edges lie on the skin, and a corner stands off by no more than the
  // rise of the chord. Nothing cut.
  double mean_radius = 0, gap_at_middle = 0, gap = 0, longest = 0;
  int middles = 0;
  for (const Vec3& p : scene.x) {
    mean_radius += p.head<2>().norm();
    gap = std::max(gap, scene.tree->signed_distance(p));
  }
  mean_radius /= static_cast<double>(scene.x.size());
  for (const Triangle& t : scene.triangles)
    for (int k = 0; k < 3; ++k) {
      const Vec3 &a = scene.x[t[k]], &b = scene.x[t[(k + 1) % 3]];
      const Vec3 across(a[0] - b[0], a[1] - b[1], 0);
      if (across.norm() < 0.9 * (a - b).norm()) continue;  // edges round the body
      gap_at_middle += scene.tree->signed_distance(0.5 * (a + b));
      ++middles;
      longest = std::max(longest, across.norm());
    }
  gap_at_middle /= middles;
  EXPECT_GT(gap_at_middle, 0);
  EXPECT_LT(gap_at_middle, c.offset);
  EXPECT_LT(gap, c.offset + longest * longest / (8 * kRadius) + 1e-5);
  EXPECT_TRUE(geometry::mesh_intersections(scene.x, scene.triangles, scene.skin.vertices,
                                           scene.skin.triangles)
                  .empty());

  // Strain away from the free rims.
  double hoop = 0, axial = 0, area = 0;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const double v = (scene.uv[t][0][1] + scene.uv[t][1][1] + scene.uv[t][2][1]) / 3;
    if (v < 0.01 || v > height - 0.01) continue;
    const Vec3 e = scene.membrane->state(static_cast<int>(t), scene.x).strain;
    hoop += scene.area[t] * std::sqrt(1 + 2 * e[0]);
    axial += scene.area[t] * std::sqrt(1 + 2 * e[1]);
    area += scene.area[t];
  }
  hoop /= area;
  axial /= area;
  EXPECT_NEAR(hoop, stretch, 0.005 * stretch);
  const double green = (hoop * hoop - 1) / 2;
  EXPECT_NEAR(axial, std::sqrt(1 - 2 * kPoisson * green), 0.002);
  // The middle of the layer lies a little outside the skin: the stretch follows it.
  EXPECT_NEAR(hoop, 2 * kPi * mean_radius / girth, 0.001 * stretch);

  double pressing = 0;
  particles::VectorField force(scene.x.size(), Vec3::Zero());
  scene.contact->add_gradient(scene.x, force);
  for (std::size_t i = 0; i < force.size(); ++i)
    pressing -= force[i].head<2>().dot(scene.x[i].head<2>().normalized());
  const double expected = 2 * kPi * hoop * kStiffness * green * height;
  EXPECT_NEAR(pressing, expected, 0.01 * expected);
  const double nominal = 2 * kPi * stretch * kStiffness * (stretch * stretch - 1) / 2 * height;
  EXPECT_NEAR(pressing, nominal, 0.05 * nominal);
  RecordProperty("hoop_1e-5", static_cast<int>(1e5 * hoop));
  RecordProperty("axial_1e-5", static_cast<int>(1e5 * axial));
  RecordProperty("force_over_effective_1e-4", static_cast<int>(1e4 * pressing / expected));
  RecordProperty("force_over_nominal_1e-4", static_cast<int>(1e4 * pressing / nominal));
  RecordProperty("gap_middle_um", static_cast<int>(1e6 * gap_at_middle));
  RecordProperty("iterations", outcome.work.iterations);
}

INSTANTIATE_TEST_SUITE_P(Stretch, TightTube, ::testing::Values(1.05, 1.2));

class LooseTube : public ::testing::TestWithParam<double> {};

// docs/theory/validation.md 8: a tube that stays round and hangs on a lying cylinder touches it
// along one line: greatest gap 2e, sin AD_max = e/R = BGM/(1 + BGM).
TEST_P(LooseTube, HangsEccentricallyWithTheGapAndDeviationOfTwoCircles) {
  const double mobility = GetParam(), girth = 2 * kPi * kRadius * (1 + mobility);
  const double radius = kRadius * (1 + mobility), e = radius - kRadius;
  const RolledSheet tube = support::rolled_sheet(girth, 0.03, girth / 80, 0);
  fabric::Material m;
  m.stiffness_warp = m.stiffness_weft = 5000;
  m.stiffness_shear = 2000;
  // So light that its weight does not flatten the circle, and thin enough to roll like a foil.
  const double gravity = 0.0125;
  m.bending_warp = m.bending_weft = 2.5e-4;
  ClothScene::Contact c;
  c.friction = 0.3;  // or it would creep on the facets of the cylinder without end
  particles::VectorField start;
  for (const Vec2& p : tube.place) {
    const double a = 2 * kPi * p[0] / girth + kPi / 2;  // seam at the top
    // About where it will hang, axis along −y.
    start.emplace_back(radius * std::cos(a), -p[1], radius * std::sin(a) - 0.98 * e);
  }
  ClothScene scene(tube.mesh, tube.same, start,
                   support::laid_down(support::cylinder(kRadius, -0.06, 0.09, 20, 240)), m, c,
                   gravity);
  solver::SettleOptions options;
  options.tolerance = 1e-3;
  options.max_iterations = 2000;
  const auto outcome = solver::make_quasi_static(scene.system)->settle(scene.x, options);
  EXPECT_EQ(outcome.reason, solver::SettleOutcome::Reason::converged)
      << outcome.text() << " " << outcome.residual;
  const auto normal = geometry::vertex_normals(scene.x, scene.triangles);
  double widest = 0, turned = 0, nearest = 1;  // away from the rims for the normal
  for (std::size_t i = 0; i < scene.x.size(); ++i) {
    const Vec3 radial = Vec3(scene.x[i][0], 0, scene.x[i][2]).normalized();
    const double gap = std::hypot(scene.x[i][0], scene.x[i][2]) - kRadius;
    widest = std::max(widest, gap);
    nearest = std::min(nearest, gap);
    if (tube.place[i][1] < 0.007 || tube.place[i][1] > 0.023) continue;
    turned = std::max(turned, std::acos(std::min(1.0, std::abs(normal[i].dot(radial)))));
  }
  EXPECT_GT(nearest, 0);
  EXPECT_LT(nearest, c.offset + 1e-4);  // and the rise of a chord
  EXPECT_NEAR(widest + nearest, 2 * e, 0.015 * 2 * e);
  EXPECT_NEAR(degrees(turned), degrees(std::asin(mobility / (1 + mobility))), 0.5);
  RecordProperty("widest_um", static_cast<int>(1e6 * widest));
  RecordProperty("turned_mdeg", static_cast<int>(1e3 * degrees(turned)));
  RecordProperty("iterations", outcome.work.iterations);
}

INSTANTIATE_TEST_SUITE_P(Mobility, LooseTube, ::testing::Values(0.1, 0.2, 0.3));

}  // namespace
}  // namespace loosefit::drape
