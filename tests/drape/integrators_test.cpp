#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstring>

#include "loosefit/contact/self_contact.h"
#include "loosefit/geometry/exact_intersection.h"
#include "loosefit/solver/implicit_euler.h"
#include "loosefit/solver/quasi_static.h"
#include "loosefit/solver/semi_implicit_euler.h"
#include "support/cloth_scene.h"

namespace loosefit::drape {
namespace {

using support::ClothScene;

/// A small square over the top of a ball, pinned at its middle.
ClothScene on_a_ball(const fabric::Material& m, double friction, bool viscous) {
  const double radius = 0.04;
  const geometry::TriangleMesh sheet = support::sheet(0.06, 0.06, 0.012, 0.1);
  ClothScene::Contact c;
  c.stiffness = 1e5;
  c.offset = 1e-3;
  c.friction = friction;
  particles::VectorField start;
  for (const Vec3& p : sheet.vertices)
    start.emplace_back(p[0] - 0.03, p[1] - 0.03, radius + c.offset);
  ClothScene scene(sheet, {}, start, support::sphere(radius, 60, 120), m, c, kGravity, viscous);
  for (std::size_t i = 0; i < scene.x.size(); ++i)
    scene.system.held[i] = scene.x[i].head<2>().norm() < 0.0125;
  return scene;
}

class ThreeIntegrators : public ::testing::TestWithParam<double> {};

TEST_P(ThreeIntegrators, AgreeOnASmallDrapeWithContact) {
  const double friction = GetParam();
  fabric::Material m;
  m.stiffness_warp = m.stiffness_weft = 60;
  m.stiffness_shear = 25;
  m.bending_warp = m.bending_weft = 4e-6;  // too stiff for folds, of which there are many kinds
  std::vector<particles::VectorField> rest;
  std::vector<double> energy;
  for (int kind = 0; kind < 3; ++kind) {
    m.damping = kind == 2 ? 2e-5 : 0.01;  // explicit viscosity must stay below the stable step
    ClothScene scene = on_a_ball(m, friction, true);
    auto integrator = kind == 0   ? solver::make_quasi_static(scene.system)
                      : kind == 1 ? solver::make_implicit_euler(scene.system)
                                  : solver::make_semi_implicit_euler(scene.system);
    solver::SettleOptions options;
    options.tolerance = 1e-4;
    options.first_dt = kind == 0 ? 1e-3 : 5e-3;
    options.max_iterations = kind == 2 ? 400000 : 3000;
    const solver::SettleOutcome outcome = integrator->settle(scene.x, options);
    EXPECT_EQ(outcome.reason, solver::SettleOutcome::Reason::converged)
        << kind << " " << outcome.text() << " " << outcome.residual;
    EXPECT_GE(scene.contact->active(scene.x), 5);
    RecordProperty("iterations_" + std::to_string(kind), outcome.work.iterations);
    double potential = 0;  // without the springs of friction
    const particles::VectorField& x = scene.x;
    potential = scene.membrane->value(x) + scene.bending->value(x) + scene.gravity->value(x);
    energy.push_back(potential);
    rest.push_back(x);
  }
  // Without friction there is one equilibrium; with it a family, as wide as the last slip.
  const double near = friction == 0 ? 1e-5 : 1e-4;
  for (int kind = 1; kind < 3; ++kind) {
    double farthest = 0;
    for (std::size_t i = 0; i < rest[0].size(); ++i)
      farthest = std::max(farthest, (rest[kind][i] - rest[0][i]).norm());
    RecordProperty("apart_um_" + std::to_string(kind), static_cast<int>(1e6 * farthest));
    EXPECT_LT(farthest, near) << kind;
    EXPECT_NEAR(energy[kind], energy[0], (friction == 0 ? 1e-5 : 1e-3) * std::abs(energy[0]));
  }
}

INSTANTIATE_TEST_SUITE_P(Friction, ThreeIntegrators, ::testing::Values(0.0, 0.3));

/// Two limp squares, one on the other, over a ball: every kind of contact.
particles::VectorField layered_drape(int threads, int* self_contacts, std::size_t* cuts) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const double radius = 0.03;
  geometry::TriangleMesh sheet = support::sheet(0.09, 0.09, 0.01, 0.15, 1);
  const geometry::TriangleMesh upper = support::sheet(0.08, 0.08, 0.01, 0.15, 2);
  const int below = static_cast<int>(sheet.vertices.size());
  for (const Triangle& t : upper.triangles)
    sheet.triangles.push_back({t[0] + below, t[1] + below, t[2] + below});
  sheet.vertices.insert(sheet.vertices.end(), upper.vertices.begin(), upper.vertices.end());
  fabric::Material m;
  m.stiffness_warp = m.stiffness_weft = 200;
  m.stiffness_shear = 20;
  m.bending_warp = m.bending_weft = 1e-7;
  ClothScene::Contact c;
  c.stiffness = 1e6;
  c.offset = 5e-4;
  c.friction = 0.3;
  particles::VectorField start;
  for (const Vec3& p : sheet.vertices)
    start.emplace_back(p[0] - 0.041, p[1] - 0.039,
                       radius + c.offset + (static_cast<int>(start.size()) < below ? 0 : 6e-4));
  ClothScene scene(sheet, {}, start, support::sphere(radius, 40, 80), m, c);
  contact::SelfContact::Options options;
  options.thickness = 1e-3;
  contact::SelfContact self(scene.triangles, scene.area, static_cast<int>(start.size()), options);
  scene.system.energies.push_back(&self);
  solver::SettleOptions settle;
  settle.tolerance = 1e-2;
  settle.max_iterations = 400;
  solver::make_quasi_static(scene.system)->settle(scene.x, settle);
  *self_contacts = self.active(scene.x);
  *cuts = geometry::self_intersections(scene.x, scene.triangles).size();
  return scene.x;
}

TEST(Determinism, OneAndTwoThreadsGiveTheSameBitsAndNoSelfIntersections) {
  int contacts[3];
  std::size_t cuts[3];
  const particles::VectorField a = layered_drape(1, &contacts[0], &cuts[0]);
  const particles::VectorField b = layered_drape(2, &contacts[1], &cuts[1]);
  const particles::VectorField c = layered_drape(2, &contacts[2], &cuts[2]);
  EXPECT_GT(contacts[0], 10);  // the layers do touch
  EXPECT_EQ(cuts[0], 0u);
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)), 0);
  EXPECT_EQ(std::memcmp(b.data(), c.data(), b.size() * sizeof(Vec3)), 0);
  RecordProperty("self_contacts", contacts[0]);
}

}  // namespace
}  // namespace loosefit::drape
