// Contact pressure by both estimates: kinematic cases against docs/theory/validation.md 6.2, and
// cloth that was settled on cylinders, an elliptic and a grooved one.
#include "loosefit/maps/pressure.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/maps/compute_maps.h"
#include "loosefit/solver/quasi_static.h"
#include "support/cloth_scene.h"
#include "support/tube_garment.h"

namespace loosefit::maps {
namespace {

fabric::Material knit(double stiffness, double poisson) {
  fabric::Material m;
  m.stiffness_warp = m.stiffness_weft = stiffness;
  m.poisson = poisson;
  m.stiffness_shear = stiffness / (2 * (1 + poisson));
  m.bending_warp = m.bending_weft = 1e-9;
  m.thickness = 1e-4;
  return m;
}

/// A tube as it lies on a cylinder of `radius` with hoop and axial stretch, no forces known but 1 N
/// in all.
struct PlacedTube {
  garment::Garment garment;
  drape::Drape drape;
  body::Body body;
};
PlacedTube placed_tube(double radius, double hoop, double axial) {
  PlacedTube p;
  const double lying = radius + 5e-5;  // half the thickness off the skin
  const double girth = 2 * kPi * lying / hoop;
  p.body = testing::cylinder_body(radius, 1.0, 200, 100);
  p.garment = testing::tube_garment(girth, 0.1, 120, 40);
  p.drape = testing::settled_drape(p.garment, [&](const Vec2& uv) {
    const double a = 2 * kPi * uv.x() / girth;
    return Vec3(lying * std::cos(a), lying * std::sin(a), 0.45 + axial * uv.y());
  });
  p.drape.body_normal_force.assign(p.garment.vertex_count, 1.0 / p.garment.vertex_count);
  return p;
}

struct Row {
  double stretch, axial, tension, pressure;
};
class SleeveOnCylinder : public ::testing::TestWithParam<Row> {};

// docs/theory/validation.md 6.2, K = 200 N/m, ν = 0.3, R = 50 mm: tension per worn length and p =
// N/R.
TEST_P(SleeveOnCylinder, HasTheTensionAndPressureOfTheTable) {
  const Row row = GetParam();
  const PlacedTube tube = placed_tube(0.05, row.stretch, row.axial);
  const fabric::Material m = knit(200, 0.3);
  const auto tension = membrane_tension(tube.garment, tube.drape.positions, m);
  for (std::size_t t = 0; t < tension.size(); ++t) {
    const Triangle& c = tube.garment.triangles[t];
    Vec3 middle = Vec3::Zero();
    for (int v : c) middle += tube.drape.positions[v] / 3;
    const Vec3 hoop = Vec3(-middle.y(), middle.x(), 0).normalized();
    ASSERT_NEAR(hoop.dot(tension[t] * hoop), row.tension, 0.003 * row.tension);
    // The free sleeve carries nothing along its axis, the held one ν times the hoop stress.
    ASSERT_NEAR(tension[t](2, 2),
                row.axial < 1 ? 0 : 0.3 * row.tension / (row.stretch * row.stretch),
                0.003 * row.tension);
  }
  const PressureField field = contact_pressure(tube.garment, tube.drape, tube.body, m);
  for (double p : field.membrane) ASSERT_NEAR(p, row.pressure, 0.01 * row.pressure);
}
INSTANTIATE_TEST_SUITE_P(
    Table, SleeveOnCylinder,
    ::testing::Values(Row{1.05, 0.984505, 10.931890, 218.638},
                      Row{1.1, 0.967988, 23.863942, 477.279},
                      Row{1.2, 0.931665, 56.672720, 1133.454},
                      Row{1.3, 0.890505, 100.729308, 2014.586},
                      Row{1.5, 0.790569, 237.170825, 4743.417}, Row{1.05, 1, 11.826923, 236.538},
                      Row{1.1, 1, 25.384615, 507.692}, Row{1.2, 1, 58.021978, 1160.440},
                      Row{1.3, 1, 98.571429, 1971.429}, Row{1.5, 1, 206.043956, 4120.879}));

TEST(ContactForce, IntegratesToTheTotalNormalForce) {
  PlacedTube tube = placed_tube(0.05, 1.2, 0.93);
  double total = 0;
  for (int v = 0; v < tube.garment.vertex_count; ++v)
    total += tube.drape.body_normal_force[v] = v % 3 == 0 ? 0 : 1e-3 * (v % 7);
  const PressureField field = contact_pressure(tube.garment, tube.drape, tube.body, knit(200, 0.3));
  double sum = 0, area = 0;
  for (std::size_t v = 0; v < field.contact.size(); ++v) {
    sum += field.contact[v] * field.area[v];
    area += field.area[v];
    EXPECT_EQ(field.contact[v] == 0, tube.drape.body_normal_force[v] == 0);
  }
  EXPECT_NEAR(sum, total, 1e-12 * total);
  EXPECT_NEAR(area, 2 * kPi * 0.05 * 0.1 * 0.93, 0.002 * area);  // as worn, not as cut
}

// Tension T in every direction on a ball presses with 2 T/R.
TEST(MembranePressure, OnASphereIsTwiceTheTensionOverTheRadius) {
  const double radius = 0.08, stretch = 1.2;
  body::Body body;
  body.surface = support::sphere(radius, 120, 240);
  for (const Vec3& p : body.surface.vertices) body.normals.push_back(p.normalized());
  garment::Garment g;
  const geometry::TriangleMesh flat = support::sheet(0.01, 0.01, 0.001, 0.2);
  g.vertex_count = static_cast<int>(flat.vertices.size());
  g.triangles = flat.triangles;
  g.triangle_uv = support::flat_uv(flat);
  drape::Drape drape;
  for (const Vec3& p : flat.vertices) {
    // Stereographic from the far side, on the equator where the mesh of the ball is even: the
    // stretch is the same in all directions, and over so small a patch everywhere.
    const double y = stretch * (p.x() - 0.005) / (2 * radius);
    const double z = stretch * (p.y() - 0.005) / (2 * radius), square = y * y + z * z;
    drape.positions.push_back((radius + 5e-5) * Vec3(1 - square, 2 * y, 2 * z) / (1 + square));
  }
  drape.body_normal_force.assign(g.vertex_count, 0.0);
  const PressureField field = contact_pressure(g, drape, body, knit(200, 0.3), 0);
  const double tension = 200 / 0.7 * (stretch * stretch - 1) / 2;
  const double expected = 2 * tension / radius;
  for (int v = 0; v < g.vertex_count; ++v)
    EXPECT_NEAR(field.membrane[v], expected, 0.03 * expected);
  const PressureAgreement a = compare_pressures(field, {});
  EXPECT_NEAR(a.membrane_mean, expected, 0.015 * expected);
}

// On a saddle the sign follows the direction of the pull; a pull along the hollow presses nowhere.
TEST(MembranePressure, OnASaddleIsThereOnlyForAPullOverTheRidge) {
  constexpr double big = 0.2, small = 0.05;
  constexpr int n = 240, m = 90;
  body::Body body;
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const double u = 2 * kPi * i / n, v = 2 * kPi * j / m;
      const Vec3 normal(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
      body.normals.push_back(normal);
      body.surface.vertices.push_back(big * Vec3(std::cos(u), std::sin(u), 0) + small * normal);
      const auto id = [&](int a, int b) { return b % m * n + a % n; };
      body.surface.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      body.surface.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  const geometry::TriangleMesh flat = support::sheet(0.02, 0.02, 0.002);
  garment::Garment g;
  g.vertex_count = static_cast<int>(flat.vertices.size());
  g.triangles = flat.triangles;
  g.triangle_uv = support::flat_uv(flat);
  const fabric::Material cloth = knit(200, 0);  // no Poisson: tension only along the pull
  // A patch round the waist of the hole (v = π), u across the ridge, v along the hollow.
  const auto press = [&](double over, double along) {
    drape::Drape drape;
    for (const Vec3& p : flat.vertices) {
      const double v = kPi - over * (p.y() - 0.01) / small;
      const double u = along * (p.x() - 0.01) / (big - small);
      const double r = big + (small + 5e-5) * std::cos(v);
      drape.positions.emplace_back(r * std::cos(u), r * std::sin(u), (small + 5e-5) * std::sin(v));
    }
    drape.body_normal_force.assign(g.vertex_count, 0.0);
    return compare_pressures(contact_pressure(g, drape, body, cloth, 0), {}).membrane_mean;
  };
  const auto tension = [](double stretch) { return stretch * 200 * (stretch * stretch - 1) / 2; };
  EXPECT_NEAR(press(1.2, 1.0), tension(1.2) / small, 0.05 * tension(1.2) / small);
  EXPECT_EQ(press(1.0, 1.2), 0);
  // Both: what the hollow lifts is missing from what the ridge presses. Stretch λ in both
  // directions: N = S = K E per worn length.
  const double both = 200 * 0.22 * (1 / small - 1 / (big - small));
  EXPECT_NEAR(press(1.2, 1.2), both, 0.06 * both);
}

TEST(MembranePressure, OfLimpClothOnAFlatTopIsItsWeight) {
  body::Body body;
  body.surface = support::box_mesh(Vec3(0.2, 0.2, 0.05));
  for (const Vec3& p : body.surface.vertices)
    body.normals.push_back(Vec3(0, 0, p.z()).normalized());
  const geometry::TriangleMesh flat = support::sheet(0.1, 0.1, 0.01);
  garment::Garment g;
  g.vertex_count = static_cast<int>(flat.vertices.size());
  g.triangles = flat.triangles;
  g.triangle_uv = support::flat_uv(flat);
  drape::Drape above, below;
  for (const Vec3& p : flat.vertices) {
    above.positions.emplace_back(p.x() - 0.05, p.y() - 0.05, 0.05005);
    below.positions.emplace_back(p.x() - 0.05, p.y() - 0.05, -0.05005);
  }
  above.body_normal_force.assign(g.vertex_count, 0.0);
  below.body_normal_force = above.body_normal_force;
  g.vertex_mass = contact_pressure(g, above, body, knit(200, 0)).area;
  for (double& mass : g.vertex_mass) mass *= 0.2;  // kg/m²
  for (double p : contact_pressure(g, above, body, knit(200, 0)).membrane)
    EXPECT_NEAR(p, 0.2 * kGravity, 1e-9);
  for (double p : contact_pressure(g, below, body, knit(200, 0)).membrane) EXPECT_EQ(p, 0);
}

TEST(Pressure, IsZeroBeyondTheContactTolerance) {
  PlacedTube tube = placed_tube(0.05, 1.2, 1);
  const fabric::Material m = knit(200, 0.3);
  for (Vec3& p : tube.drape.positions) p.head<2>() *= 1 + (contact_tolerance(m) + 4e-4) / 0.05;
  tube.drape.body_normal_force.assign(tube.garment.vertex_count, 0.0);
  const PressureField field = contact_pressure(tube.garment, tube.drape, tube.body, m);
  for (double p : field.membrane) EXPECT_EQ(p, 0);
  for (double p : field.contact) EXPECT_EQ(p, 0);
  const PressureAgreement none = compare_pressures(field, {});
  EXPECT_EQ(none.contact_area, 0);
  EXPECT_EQ(none.contact_force, 0);
  EXPECT_TRUE(std::isnan(none.contact_mean));
  EXPECT_TRUE(std::isnan(none.correlation));
}

TEST(Pressure, NeedsTheForcesOfTheDrape) {
  PlacedTube tube = placed_tube(0.05, 1.2, 1);
  tube.drape.body_normal_force.pop_back();
  EXPECT_THROW(contact_pressure(tube.garment, tube.drape, tube.body, knit(200, 0)), InvalidInput);
  tube.drape.body_normal_force.clear();
  EXPECT_THROW(contact_pressure(tube.garment, tube.drape, tube.body, knit(200, 0)), InvalidInput);
}

TEST(Agreement, IsThatOfTwoKnownFields) {
  PressureField field;
  field.contact = {100, 200, 300, 0, 0};
  field.membrane = {110, 220, 330, 50, 70};
  field.area = {1, 1, 2, 1, 4};
  field.touching = {1, 1, 1, 1, 0};  // the last does not touch
  const std::vector<body::Region> regions = {body::Region::chest, body::Region::chest,
                                             body::Region::chest, body::Region::abdomen,
                                             body::Region::abdomen};
  const PressureAgreement all = compare_pressures(field, regions);
  EXPECT_DOUBLE_EQ(all.contact_area, 5);
  EXPECT_DOUBLE_EQ(all.contact_force, 900);
  EXPECT_DOUBLE_EQ(all.membrane_force, 1040);
  EXPECT_DOUBLE_EQ(all.contact_mean, 180);
  EXPECT_DOUBLE_EQ(all.membrane_mean, 208);
  EXPECT_NEAR(all.rms_difference, std::sqrt((100 + 400 + 2 * 900 + 2500) / 5.0), 1e-9);
  const PressureAgreement chest = compare_pressures(field, regions, body::Region::chest);
  EXPECT_NEAR(chest.correlation, 1, 1e-12);
  EXPECT_DOUBLE_EQ(chest.contact_area, 4);
  EXPECT_TRUE(std::isnan(compare_pressures(field, regions, body::Region::abdomen).correlation));
  EXPECT_EQ(compare_pressures(field, regions, body::Region::hips).contact_area, 0);
}

TEST(Agreement, ClassesShareTheWornArea) {
  PressureField field;
  field.contact = {0, 299, 300, 699, 2000, 3999, 4000, 9000};
  field.membrane = field.contact;
  field.area = {2, 1, 1, 1, 1, 1, 1, 2};
  field.touching.assign(8, 1);
  const std::vector<double> share = pressure_class_shares(field);
  const std::vector<double> expected = {0.2, 0.1, 0.2, 0.1, 0.1, 0.3};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(share[i], expected[i], 1e-12) << i;
}

TEST(PressureMap, ShowsBothEstimatesInKilopascalWithTheClassesAsBreaks) {
  const PlacedTube tube = placed_tube(0.05, 1.2, 1);
  const WornGarment worn = relate(tube.garment, tube.drape.positions, tube.body);
  const PressureField field = contact_pressure(tube.garment, tube.drape, tube.body, knit(200, 0.3));
  const auto maps =
      compute_maps(tube.garment, tube.drape, worn, {"pressure"}, {.pressure = &field});
  ASSERT_EQ(maps.size(), 3u);
  EXPECT_EQ(maps[0].array, "pressure_kPa");
  EXPECT_EQ(maps[1].array, "pressure_membrane_kPa");
  EXPECT_EQ(maps[2].array, "pressure_difference_kPa");
  EXPECT_TRUE(maps[0].pictured);
  EXPECT_FALSE(maps[1].pictured);
  EXPECT_EQ(maps[0].breaks, (std::vector<double>{0, 0.05, 0.3, 0.7, 2.7, 4}));
  for (std::size_t v = 0; v < field.contact.size(); ++v) {
    EXPECT_DOUBLE_EQ(maps[0].values[v], field.contact[v] / 1000);
    EXPECT_NEAR(maps[1].values[v], 1.16044, 0.012);  // the table, held, 1.2
    EXPECT_NEAR(maps[2].values[v], maps[1].values[v] - maps[0].values[v], 1e-12);
  }
  EXPECT_THROW(compute_maps(tube.garment, tube.drape, worn, {"pressure"}), InvalidInput);
}

/// A tight tube with its seam, settled without friction on an upright body of any section.
struct Settled {
  garment::Garment garment;
  drape::Drape drape;
  body::Body body;
  fabric::Material material;
  PressureField field;
  double tension = 0;  ///< expected hoop tension per worn length [N/m]
};

/// `section(a)`: point of the body's section at parameter a ∈ [0, 2π), counter-clockwise.
Settled settle_on(const std::function<Vec2(double)>& section, double start_radius, double stretch,
                  double held_girth, int around, double height) {
  Settled s;
  const double girth = held_girth / stretch;
  const support::RolledSheet tube = support::rolled_sheet(girth, height, girth / around, 0.15);
  s.material = knit(200, 0.3);
  support::ClothScene::Contact c;
  c.offset = 5e-5;
  c.stiffness = 2e8;
  c.spacing = 0.003;
  geometry::TriangleMesh skin = support::cylinder(1, -0.05, height + 0.05, 40, 360);
  for (Vec3& p : skin.vertices)
    if (p.head<2>().norm() > 0.5) p.head<2>() = section(std::atan2(p.y(), p.x()));
  particles::VectorField start;
  for (const Vec2& p : tube.place) {
    const double a = 2 * kPi * p[0] / girth;
    start.emplace_back(start_radius * std::cos(a), start_radius * std::sin(a), p[1]);
  }
  support::ClothScene scene(tube.mesh, tube.same, start, skin, s.material, c, 0.0);
  solver::SettleOptions options;
  options.tolerance = 1e-6;
  const auto outcome = solver::make_quasi_static(scene.system)->settle(scene.x, options);
  EXPECT_EQ(outcome.reason, solver::SettleOutcome::Reason::converged)
      << outcome.text() << " " << outcome.residual;
  s.garment.vertex_count = static_cast<int>(scene.x.size());
  s.garment.triangles = scene.triangles;
  s.garment.triangle_uv = scene.uv;
  s.drape.positions = scene.x;
  s.drape.body_normal_force.assign(scene.x.size(), 0.0);
  scene.contact->add_normal_force(scene.x, s.drape.body_normal_force);
  s.body.surface = skin;
  s.body.normals = geometry::vertex_normals(skin.vertices, skin.triangles);
  s.field = contact_pressure(s.garment, s.drape, s.body, s.material, 0);
  const double green = (stretch * stretch - 1) / 2;
  s.tension = stretch * 200 * green / std::sqrt(1 - 2 * 0.3 * green);
  return s;
}

/// Area means of both estimates over vertices that `wanted` picks.
struct Means {
  double contact = 0, membrane = 0, area = 0;
};
Means means_where(const Settled& s, const std::function<bool(const Vec3&)>& wanted) {
  Means m;
  for (std::size_t v = 0; v < s.drape.positions.size(); ++v)
    if (wanted(s.drape.positions[v])) {
      m.area += s.field.area[v];
      m.contact += s.field.area[v] * s.field.contact[v];
      m.membrane += s.field.area[v] * s.field.membrane[v];
    }
  m.contact /= m.area;
  m.membrane /= m.area;
  return m;
}

constexpr double kHeight = 0.05, kRim = 0.01;
bool inner(const Vec3& p) { return p.z() > kRim && p.z() < kHeight - 1.3 * kRim; }

// docs/theory/sensor_metrics.md 10: p = T/R within 2 %, both estimates within 5 % of each other.
TEST(SettledSleeve, OnACylinderPressesWithTensionOverRadiusByBothEstimates) {
  const double radius = 0.05;
  const Settled s =
      settle_on([&](double a) { return Vec2(radius * std::cos(a), radius * std::sin(a)); },
                1.01 * radius, 1.2, 2 * kPi * radius, 90, kHeight);
  const Means m = means_where(s, inner);
  const double expected = s.tension / radius;
  EXPECT_NEAR(m.contact, expected, 0.02 * expected);
  EXPECT_NEAR(m.membrane, expected, 0.02 * expected);
  const PressureAgreement a = compare_pressures(s.field, {});
  EXPECT_NEAR(a.membrane_force, a.contact_force, 0.05 * a.contact_force);
  EXPECT_LT(a.rms_difference, 0.25 * a.contact_mean);
  double total = 0;
  for (double f : s.drape.body_normal_force) total += f;
  EXPECT_NEAR(a.contact_force, total, 1e-12 * total);
  RecordProperty("contact_over_expected_1e-4", static_cast<int>(1e4 * m.contact / expected));
  RecordProperty("membrane_over_expected_1e-4", static_cast<int>(1e4 * m.membrane / expected));
  RecordProperty("rms_over_mean_1e-4", static_cast<int>(1e4 * a.rms_difference / a.contact_mean));
}

// docs/theory/validation.md 6.2: a frictionless convex section has constant tension, so p follows
// the curvature.
TEST(SettledSleeve, OnAnEllipticCylinderFollowsTheCurvature) {
  constexpr double a = 0.06, b = 0.04;
  double girth = 0;
  for (int i = 0; i < 3600; ++i) {
    const double t = 2 * kPi * (i + 0.5) / 3600;
    girth += std::hypot(a * std::sin(t), b * std::cos(t)) * 2 * kPi / 3600;
  }
  const Settled s = settle_on([&](double t) { return Vec2(a * std::cos(t), b * std::sin(t)); },
                              1.02 * a, 1.2, girth, 110, kHeight);
  // Windows of ± 0.2 rad of the parameter; the curvature is averaged over them by arc length.
  for (double at : {0.0, 0.5, 1.0, kPi / 2}) {
    double curvature = 0, arc = 0;
    for (int i = -50; i <= 50; ++i) {
      const double t = at + 0.2 * i / 50;
      const double speed = std::hypot(a * std::sin(t), b * std::cos(t));
      curvature += a * b / (speed * speed);
      arc += speed;
    }
    const double expected = s.tension * curvature / arc;
    const Means m = means_where(s, [&](const Vec3& p) {
      const double t = std::atan2(std::abs(p.y()) / b, std::abs(p.x()) / a);
      return inner(p) && std::abs(t - at) < 0.2;
    });
    EXPECT_NEAR(m.contact, expected, 0.06 * expected) << at;
    EXPECT_NEAR(m.membrane, expected, 0.04 * expected) << at;
  }
  const PressureAgreement agreement = compare_pressures(s.field, {});
  EXPECT_GT(agreement.correlation, 0.8);
  EXPECT_NEAR(agreement.membrane_force, agreement.contact_force, 0.05 * agreement.contact_force);
  RecordProperty("correlation_1e-3", static_cast<int>(1e3 * agreement.correlation));
}

// A hollow, the spine furrow of a trunk: the sleeve bridges it, so there is a gap and no pressure
// by either estimate, and more than elsewhere at its lips.
TEST(SettledSleeve, OverAGrooveBridgesItWithoutPressure) {
  constexpr double radius = 0.05, depth = 0.008, half_width = 0.35;  // [m], [m], [rad]
  const auto section = [&](double t) {
    const double share = std::abs(t) / half_width;
    const double r = radius - (share < 1 ? 0.5 * depth * (1 + std::cos(kPi * share)) : 0);
    return Vec2(r * std::cos(t), r * std::sin(t));
  };
  const Settled s = settle_on(section, 1.01 * radius, 1.2, 2 * kPi * radius * 0.997, 90, kHeight);
  const Means furrow = means_where(
      s, [&](const Vec3& p) { return inner(p) && std::abs(std::atan2(p.y(), p.x())) < 0.2; });
  EXPECT_EQ(furrow.contact, 0);
  EXPECT_EQ(furrow.membrane, 0);
  const geometry::ClosestPointTree tree(s.body.surface);
  for (const Vec3& p : s.drape.positions)
    if (std::abs(std::atan2(p.y(), p.x())) < 0.1) {
      EXPECT_GT(tree.signed_distance(p), 0.003);
    }
  const Means back = means_where(
      s, [&](const Vec3& p) { return inner(p) && std::abs(std::atan2(p.y(), p.x())) > 1; });
  EXPECT_NEAR(back.contact, s.tension / radius, 0.06 * s.tension / radius);
  EXPECT_NEAR(back.membrane, back.contact, 0.05 * back.contact);
  const Means lips = means_where(s, [&](const Vec3& p) {
    const double t = std::abs(std::atan2(p.y(), p.x()));
    return inner(p) && t > 0.25 && t < 0.42;
  });
  EXPECT_GT(lips.contact, 1.5 * back.contact);
  EXPECT_GT(lips.membrane, 1.2 * back.membrane);
}

}  // namespace
}  // namespace loosefit::maps
