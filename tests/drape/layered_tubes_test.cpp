#include <gtest/gtest.h>

#include "loosefit/drape/cloth_model.h"
#include "loosefit/drape/contact_body.h"
#include "loosefit/geometry/exact_intersection.h"
#include "loosefit/solver/integrator.h"
#include "loosefit/solver/quasi_static.h"
#include "support/shapes.h"
#include "support/tube_garment.h"

namespace loosefit::drape {
namespace {

constexpr double kRadius = 0.05, kHeight = 0.04;

fabric::Material foil(double stiffness, double thickness) {
  fabric::Material m;
  m.stiffness_warp = m.stiffness_weft = stiffness;
  m.poisson = 0;  // then friction along the axis does not matter
  m.stiffness_shear = stiffness / 2;
  m.bending_warp = m.bending_weft = 1e-9;
  m.thickness = thickness;
  m.friction_self = 0.3;
  return m;
}

garment::Garment tube(double stretch, int around, int along, const fabric::Material& m) {
  const double girth = 2 * kPi * kRadius / stretch;
  garment::Garment g = testing::tube_garment(girth, kHeight, around, along);
  g.triangle_membrane_factor.assign(g.triangles.size(), 1.0);
  g.triangle_added_bending.assign(g.triangles.size(), 0.0);
  g.mass = g.area * m.areal_density;
  g.vertex_mass.assign(g.vertex_count, g.mass / g.vertex_count);
  return g;
}

void wrap(const garment::Garment& g, double stretch, double radius, double turn,
          std::vector<Vec3>& x) {
  const double girth = 2 * kPi * kRadius / stretch;
  for (const Vec2& uv : g.vertex_uv) {
    const double a = 2 * kPi * uv[0] / girth + turn;
    x.emplace_back(radius * std::cos(a), radius * std::sin(a), uv[1]);
  }
}

double radial(const std::vector<Vec3>& f, const std::vector<Vec3>& x, std::size_t first,
              std::size_t last) {
  double sum = 0;
  for (std::size_t i = first; i < last; ++i) sum += f[i].head<2>().dot(x[i].head<2>().normalized());
  return sum;
}

/// 2π λ K E per rest length, with the stretch that the tube really has.
double hoop_force(const garment::Garment& g, const std::vector<Vec3>& x, std::size_t first,
                  double stretch, double stiffness) {
  double radius = 0;
  for (int i = 0; i < g.vertex_count; ++i) radius += x[first + i].head<2>().norm() / g.vertex_count;
  const double hoop = stretch * radius / kRadius;
  return 2 * kPi * hoop * stiffness * (hoop * hoop - 1) / 2 * kHeight;
}

// Laplace: each tube presses with T/R. The outer one presses on the inner, which hands it on: the
// body carries p = (T1 + T2)/R, all of it through the inner tube.
TEST(LayeredTubes, PressThroughToTheBodyWithTheSumOfTheirTensions) {
  const fabric::Material inner = foil(150, 4e-4), outer = foil(300, 6e-4);
  const double stretch_in = 1.05, stretch_out = 1.15;
  const garment::Garment a = tube(stretch_in, 90, 11, inner), b = tube(stretch_out, 83, 10, outer);
  std::vector<Vec3> x;
  wrap(a, stretch_in, 1.02 * kRadius, 0, x);
  wrap(b, stretch_out, 1.06 * kRadius, 0.01, x);
  const std::size_t split = a.vertex_count;

  body::Body cylinder;
  cylinder.surface = support::cylinder(kRadius, -0.05, 0.09, 20, 240);
  const auto body = with_field(cylinder, bounds(x), 0.003);
  DrapeOptions options;
  options.gravity = 0;
  ClothModel model({{&a, inner, inner.thickness}, {&b, outer, outer.thickness}}, options);
  model.set_body(*body);
  ASSERT_EQ(model.mesh().layers(), 2);
  solver::SettleOptions settle;
  settle.tolerance = 1e-5;  // [N]: nothing has weight here
  const auto outcome = solver::make_quasi_static(model.system())->settle(x, settle);
  EXPECT_EQ(outcome.reason, solver::SettleOutcome::Reason::converged) << outcome.text();

  EXPECT_TRUE(geometry::self_intersections(x, model.mesh().triangles).empty());
  std::vector<Vec3> on_inner(x.size(), Vec3::Zero()), on_outer(x.size(), Vec3::Zero());
  model.body(0).add_gradient(x, on_inner);
  model.body(1).add_gradient(x, on_outer);
  const double t1 = hoop_force(a, x, 0, stretch_in, 150);
  const double t2 = hoop_force(b, x, split, stretch_out, 300);
  EXPECT_GT(t2, 4 * t1) << "what is handed on is most of it";
  EXPECT_NEAR(-radial(on_inner, x, 0, split), t1 + t2, 0.015 * (t1 + t2));
  EXPECT_EQ(radial(on_outer, x, split, x.size()), 0) << "it does not touch the body";

  std::vector<Vec3> between(x.size(), Vec3::Zero());
  model.self().add_gradient(x, between);
  EXPECT_NEAR(radial(between, x, 0, split), t2, 0.015 * t2) << "pushes the inner one inwards";
  EXPECT_NEAR(-radial(between, x, split, x.size()), t2, 0.015 * t2);

  // Half of each thickness lies between the two, a little compressed, and the rise of a chord.
  double in = 0, out = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    (i < split ? in : out) += x[i].head<2>().norm() / (i < split ? a : b).vertex_count;
  EXPECT_GT(out - in, 0.5 * 5e-4);
  EXPECT_LT(out - in, 5e-4 + 1e-4);
  RecordProperty("iterations", outcome.work.iterations);
  RecordProperty("gap_um", static_cast<int>(1e6 * (out - in)));
}

}  // namespace
}  // namespace loosefit::drape
