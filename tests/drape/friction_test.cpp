#include <gtest/gtest.h>

#include "loosefit/solver/implicit_euler.h"
#include "loosefit/solver/quasi_static.h"
#include "support/cloth_scene.h"

namespace loosefit::drape {
namespace {

using support::ClothScene;
constexpr double kFriction = 0.3;

fabric::Material block_material() {
  fabric::Material m;
  m.stiffness_warp = m.stiffness_weft = 2000;
  m.stiffness_shear = 800;
  m.bending_warp = m.bending_weft = 1e-3;
  return m;
}

/// A stiff little sheet at rest on the upper face of a big box that is tilted by `slope` [rad]
/// about the y axis, its weight already carried by the layer.
struct Incline {
  std::unique_ptr<ClothScene> scene;
  Vec3 down_hill;

  explicit Incline(double slope, double stick_reach = 1e-4) {
    const Eigen::AngleAxisd tilt(slope, Vec3::UnitY());
    down_hill = tilt * Vec3::UnitX();
    const fabric::Material m = block_material();
    ClothScene::Contact c;
    c.friction = kFriction;
    c.stick_reach = stick_reach;
    const double compression = m.areal_density * kGravity * std::cos(slope) / c.stiffness;
    geometry::TriangleMesh box = support::box_mesh({0.6, 0.2, 0.05});
    for (Vec3& p : box.vertices) p = tilt * p;
    const geometry::TriangleMesh sheet = support::sheet(0.04, 0.04, 0.01, 0.1);
    particles::VectorField start;
    for (const Vec3& p : sheet.vertices)
      start.push_back(tilt * Vec3(p[0] - 0.05, p[1] - 0.02, 0.05 + c.offset - compression));
    scene = std::make_unique<ClothScene>(sheet, std::map<int, int>{}, start, box, m, c);
  }

  double moved(const particles::VectorField& from) const {
    double sum = 0;
    for (std::size_t i = 0; i < from.size(); ++i)
      sum += down_hill.dot(scene->x[i] - from[i]) / static_cast<double>(from.size());
    return sum;
  }
};

TEST(Incline, SticksJustBelowTheFrictionAngleAndSlidesJustAbove) {
  for (double share : {0.5, 0.99, 1.01, 1.2}) {
    Incline incline(std::atan(share * kFriction));
    const particles::VectorField start = incline.scene->x;
    solver::SettleOptions options;
    options.tolerance = 1e-4;
    options.first_dt = 1e-3;
    options.max_iterations = 300;
    const auto outcome =
        solver::make_quasi_static(incline.scene->system)->settle(incline.scene->x, options);
    const double way = incline.moved(start);
    RecordProperty("moved_um_at_" + std::to_string(share), static_cast<int>(1e6 * way));
    if (share < 1) {
      EXPECT_EQ(outcome.reason, solver::SettleOutcome::Reason::converged)
          << share << " " << outcome.residual;
      EXPECT_LT(way, 2e-4) << share;
      EXPECT_GT(way, 0) << share;
    } else {
      EXPECT_NE(outcome.reason, solver::SettleOutcome::Reason::converged) << share;
      EXPECT_GT(way, 5e-3) << share;
    }
  }
}

TEST(Incline, AShareOfFrictionHoldsThatShareOfTheSlope) {
  for (double slope : {0.99, 1.01}) {
    Incline incline(std::atan(slope * 0.2 * kFriction));
    incline.scene->contact->set_friction_share(0.2);
    const particles::VectorField start = incline.scene->x;
    solver::SettleOptions options;
    options.tolerance = 1e-4;
    options.first_dt = 1e-3;
    options.max_iterations = 300;
    solver::make_quasi_static(incline.scene->system)->settle(incline.scene->x, options);
    EXPECT_EQ(incline.moved(start) < 2e-4, slope < 1) << slope << " " << incline.moved(start);
  }
}

TEST(Incline, SlidesWithTheAccelerationOfCoulomb) {
  const double slope = radians(30), dt = 0.004;
  const int steps = 25;
  Incline incline(slope, 1e-5);  // the first moves, still on the elastic creep, must not count
  const particles::VectorField start = incline.scene->x;
  solver::SettleOptions options;
  options.first_dt = dt;
  options.max_iterations = steps;
  const auto outcome =
      solver::make_implicit_euler(incline.scene->system)->settle(incline.scene->x, options);
  EXPECT_EQ(outcome.reason, solver::SettleOutcome::Reason::iteration_limit);
  const double a = kGravity * (std::sin(slope) - kFriction * std::cos(slope));
  const double expected = a * dt * dt * steps * (steps + 1) / 2;
  EXPECT_NEAR(incline.moved(start), expected, 0.01 * expected);
  RecordProperty("moved_um", static_cast<int>(1e6 * incline.moved(start)));
  RecordProperty("expected_um", static_cast<int>(1e6 * expected));
}

/// Narrow limp strip over a lying cylinder of radius R, ends hanging free
/// (docs/theory/validation.md 3.2). Returns how far it has slipped [m].
double slip_over_cylinder(double light, double heavy, double friction, bool* converged) {
  const double radius = 0.01, wrap = kPi * radius, length = light + wrap + heavy;
  fabric::Material m;
  m.stiffness_warp = m.stiffness_weft = 500;
  m.stiffness_shear = 200;
  m.poisson = 0;
  m.bending_warp = m.bending_weft = 1e-9;  // bending length 1 mm, far below R
  ClothScene::Contact c;
  c.friction = friction;
  c.spacing = 0.002;
  c.offset = 1e-4;
  c.stick_reach = 5e-5;
  const geometry::TriangleMesh strip = support::sheet(length, 0.002, 0.0015, 0);
  particles::VectorField start;
  const double r = radius + c.offset;
  for (const Vec3& p : strip.vertices) {
    const double s = p[0] - light;  // from the light side up, over the top, down the heavy side
    if (s < 0)
      start.emplace_back(-r, p[1], s);
    else if (s < wrap)
      start.emplace_back(-r * std::cos(s / radius), p[1], r * std::sin(s / radius));
    else
      start.emplace_back(r, p[1], -(s - wrap));
  }
  ClothScene scene(strip, {}, start,
                   support::laid_down(support::cylinder(radius, -0.02, 0.02, 4, 128)), m, c);
  solver::SettleOptions options;
  options.tolerance = 2e-3;
  options.first_dt = 1e-3;
  options.max_iterations = 600;
  const auto outcome = solver::make_quasi_static(scene.system)->settle(scene.x, options);
  *converged = outcome.reason == solver::SettleOutcome::Reason::converged;
  double lowest = 0;
  for (const Vec3& p : scene.x) lowest = std::min(lowest, p[2]);
  return -lowest - heavy;
}

TEST(Capstan, HeavyStripHoldsBelowTheCriticalLengthAndSlipsAbove) {
  const double light = 0.04, critical = 3.057112 * light;  // R = L1/4, μ = 0.3
  bool converged = false;
  const double held = slip_over_cylinder(light, 0.95 * critical, kFriction, &converged);
  EXPECT_TRUE(converged);
  EXPECT_LT(held, 1e-3);
  const double slipped = slip_over_cylinder(light, 1.05 * critical, kFriction, &converged);
  EXPECT_FALSE(converged);
  EXPECT_GT(slipped, 5e-3);
  RecordProperty("held_um", static_cast<int>(1e6 * held));
  RecordProperty("slipped_um", static_cast<int>(1e6 * slipped));
}

}  // namespace
}  // namespace loosefit::drape
