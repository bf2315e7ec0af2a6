#include "loosefit/contact/self_contact.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstring>
#include <limits>
#include <random>

#include "loosefit/base/error.h"
#include "support/law_checker.h"
#include "support/shapes.h"

namespace loosefit::contact {
namespace {

constexpr double kThickness = 2e-3;
constexpr double kStatic = std::numeric_limits<double>::infinity();

SelfContact two_triangles(double friction) {
  SelfContact::Options options;
  options.thickness = kThickness;
  options.friction = friction;
  return SelfContact({{0, 1, 2}, {3, 4, 5}}, {1e-4, 1.4e-4}, 6, options);
}

void expect_law(SelfContact& contact, const particles::VectorField& x, const std::string& what) {
  SCOPED_TRACE(what);
  contact.begin_step(x, kStatic);
  EXPECT_GT(contact.active(x), 0);
  support::expect_derivatives(contact, x, 1e-8, 2e-5);
  support::expect_no_net_force_or_torque(contact, x);
}

/// Lower triangle in the plane z = 0, the upper one given by its corners.
particles::VectorField over(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {Vec3(0, 0, 0), Vec3(0.02, 0, 0), Vec3(0.004, 0.016, 0), a, b, c};
}

TEST(SelfContact, ForceIsTheDerivativeOfTheEnergyInEveryRegion) {
  SelfContact contact = two_triangles(0);
  expect_law(contact, over({0.008, 0.005, 1e-3}, {0.012, 0.02, 0.02}, {-0.01, 0.01, 0.03}),
             "corner over the face");
  expect_law(contact, over({0.009, -0.0007, 0.0006}, {0.013, -0.02, 0.02}, {0.0, -0.02, 0.02}),
             "corner beside an edge");
  expect_law(contact, over({-0.0006, -0.0005, 0.0007}, {-0.02, -0.005, 0.01}, {-0.01, -0.02, 0.01}),
             "corner beside a corner");
  expect_law(contact, over({0.011, -0.01, 0.001}, {0.010, 0.005, 0.0012}, {0.012, -0.01, 0.02}),
             "edge across an edge");
}

TEST(SelfContact, ForceOfNearlyParallelEdgesIsTheDerivativeOfTheEnergy) {
  SelfContact contact = two_triangles(0);
  for (double angle : {0.0, 0.002, 0.01, 0.02, 0.03}) {
    const double rise = std::tan(angle);
    expect_law(
        contact,
        over({0.003, -0.0008, 0.0004}, {0.017, -0.0008 - 0.3 * rise * 0.014, 0.0004 + rise * 0.014},
             {0.01, -0.02, 0.004}),
        "angle " + std::to_string(angle));
  }
}

TEST(SelfContact, ForceIsTheDerivativeOfTheEnergyForRandomPairs) {
  std::mt19937 rng(4);
  std::uniform_real_distribution<double> u(-1, 1);
  int tried = 0;
  for (int i = 0; i < 4000 && tried < 60; ++i) {
    particles::VectorField x(6);
    for (Vec3& p : x) p = 0.01 * Vec3(u(rng), u(rng), 0.3 * u(rng));
    SelfContact contact = two_triangles(0);
    contact.begin_step(x, kStatic);
    // Not at the very rim of the barrier, where the force is too small to difference, and not next
    // to contact, where its derivatives grow like 1/d³.
    if (contact.active(x) == 0 || contact.value(x) < 1e-9 || contact.value(x) > 1e-2) continue;
    ++tried;
    expect_law(contact, x, "case " + std::to_string(i));
  }
  EXPECT_EQ(tried, 60);
}

TEST(SelfContact, FrictionalForceIsTheDerivativeOfTheEnergyAndSumsToZero) {
  for (double slide : {0.4e-4, 4e-4}) {
    SelfContact contact = two_triangles(0.4);
    particles::VectorField x = over({0.008, 0.005, 1e-3}, {0.012, 0.02, 0.02}, {-0.01, 0.01, 0.03});
    contact.begin_step(x, kStatic);
    x[3] += slide * Vec3(0.8, 0.6, 0);
    support::expect_derivatives(contact, x, 1e-8, 2e-5);
    Vec3 sum = Vec3::Zero();
    double largest = 0;
    for (const Vec3& f : support::gradient(contact, x)) {
      sum += f;
      largest = std::max(largest, f.norm());
    }
    EXPECT_LT(sum.norm(), 1e-12 * largest);
  }
}

TEST(SelfContact, PressesHarderTheNearerAndNotBeyondTheThickness) {
  double last = std::numeric_limits<double>::infinity();
  for (double d : {1e-6, 1e-5, 1e-4, 5e-4, 1e-3, 1.9e-3}) {
    SelfContact contact = two_triangles(0);
    const particles::VectorField x =
        over({0.008, 0.005, d}, {0.012, 0.02, 0.02}, {-0.01, 0.01, 0.03});
    contact.begin_step(x, kStatic);
    const double push = -support::gradient(contact, x)[3][2];
    EXPECT_GT(push, 0) << d;
    EXPECT_LT(push, last) << d;
    last = push;
  }
  SelfContact contact = two_triangles(0);
  const particles::VectorField apart =
      over({0.008, 0.005, 2.01e-3}, {0.012, 0.02, 0.02}, {-0.01, 0.01, 0.03});
  contact.begin_step(apart, kStatic);
  EXPECT_EQ(contact.active(apart), 0);
  EXPECT_EQ(contact.value(apart), 0);
}

TEST(SelfContact, NeighboursInOneFlatSheetDoNotPushEachOther) {
  const geometry::TriangleMesh sheet = support::sheet(0.06, 0.06, 0.01, 0.15);
  std::vector<double> area(sheet.triangles.size(), 4e-5);
  SelfContact::Options options;
  options.thickness = 5e-4;
  SelfContact contact(sheet.triangles, area, static_cast<int>(sheet.vertices.size()), options);
  contact.begin_step(sheet.vertices, kStatic);
  EXPECT_EQ(contact.active(sheet.vertices), 0);
}

TEST(SelfContact, LimitsAStepThatWouldPassThrough) {
  SelfContact contact = two_triangles(0);
  const particles::VectorField x =
      over({0.008, 0.005, 1e-3}, {0.012, 0.02, 0.02}, {-0.01, 0.01, 0.03});
  particles::VectorField dx(6, Vec3::Zero());
  dx[3] = Vec3(0, 0, -0.01);
  const double share = contact.max_step(x, dx);
  EXPECT_LT(share * 0.01, 1e-3);
  EXPECT_GT(share * 0.01, 0.8e-3);
  for (Vec3& d : dx) d = Vec3(0.3, -0.2, 0.1);
  EXPECT_EQ(contact.max_step(x, dx), 1);
}

TEST(SelfContact, FusedPassEqualsValueAndGradient) {
  SelfContact contact = two_triangles(0.4);
  particles::VectorField x = over({0.008, 0.005, 1e-3}, {0.012, 0.02, 0.02}, {-0.01, 0.01, 0.03});
  contact.begin_step(x, 0.1);
  x[3] += Vec3(5e-5, 0, 1e-4);
  particles::VectorField g(6, Vec3::Zero());
  EXPECT_DOUBLE_EQ(contact.value_and_gradient(x, g), contact.value(x));
  const particles::VectorField expected = support::gradient(contact, x);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(g[i], expected[i]);
  EXPECT_GT(g[3].norm(), 0);
}

TEST(SelfContact, PatternIsSteadyWhileContactsComeAndGoAndHoldsWhatTheHessianTouches) {
  SelfContact contact = two_triangles(0.4);
  const particles::VectorField near =
      over({0.008, 0.005, 1e-3}, {0.012, 0.02, 0.02}, {-0.01, 0.01, 0.03});
  particles::VectorField apart = near;
  for (int i = 3; i < 6; ++i) apart[i][2] += 0.01;
  contact.begin_step(near, 0.1);
  const auto version = contact.pattern_version(near);
  for (int k = 0; k < 3; ++k) {
    contact.begin_step(apart, kStatic);
    EXPECT_EQ(contact.active(apart), 0);
    EXPECT_EQ(contact.pattern_version(apart), version);
    particles::BlockPattern pattern(6);
    contact.add_pattern(apart, pattern);
    EXPECT_EQ(contact.pattern_version(apart), version);
    pattern.compress();
    particles::BlockMatrix h(pattern);
    contact.begin_step(near, kStatic);
    EXPECT_EQ(contact.pattern_version(near), version);
    contact.add_hessian(near, h, particles::HessianKind::exact);  // on the kept pattern
    EXPECT_LT(
        (support::dense(h) - support::dense_hessian(contact, near, particles::HessianKind::exact))
            .norm(),
        1e-12);
  }
  // A contact of other particles is new.
  const particles::VectorField other =
      over({0.02, 0.02, 0.02}, {0.008, 0.005, 1e-3}, {-0.01, 0.01, 0.03});
  contact.begin_step(other, kStatic);
  EXPECT_NE(contact.pattern_version(other), version);
}

TEST(SelfContact, LayersOfTwoMaterialsRepelWithinTheMeanOfTheirThicknesses) {
  SelfContact::Options options;
  options.friction = 0;
  options.triangle_thickness = {1e-3, 3e-3};
  SelfContact mixed({{0, 1, 2}, {3, 4, 5}}, {1e-4, 1.4e-4}, 6, options);
  SelfContact even = two_triangles(0);  // 2 mm everywhere
  for (double d : {1e-4, 1e-3, 1.99e-3, 2.01e-3}) {
    const particles::VectorField x =
        over({0.008, 0.005, d}, {0.012, 0.02, 0.02}, {-0.01, 0.01, 0.03});
    mixed.begin_step(x, kStatic);
    even.begin_step(x, kStatic);
    EXPECT_DOUBLE_EQ(mixed.value(x), even.value(x)) << d;
    EXPECT_EQ(mixed.active(x) > 0, d < 2e-3) << d;
  }
  options.triangle_thickness = {1e-3, 1e-3};
  SelfContact thin({{0, 1, 2}, {3, 4, 5}}, {1e-4, 1.4e-4}, 6, options);
  const particles::VectorField x =
      over({0.008, 0.005, 1.5e-3}, {0.012, 0.02, 0.02}, {-0.01, 0.01, 0.03});
  thin.begin_step(x, kStatic);
  EXPECT_EQ(thin.active(x), 0);
}

TEST(SelfContact, FrictionIsThatOfThePairOfLayers) {
  const particles::VectorField start =
      over({0.008, 0.005, 1e-3}, {0.012, 0.02, 0.02}, {-0.01, 0.01, 0.03});
  particles::VectorField slid = start;
  slid[3] += Vec3(2e-3, 0, 0);
  const auto drag = [&](const Eigen::MatrixXd& between, std::vector<int> layers) {
    SelfContact::Options options;
    options.thickness = kThickness;
    options.friction = 0.4;
    options.layer_friction = between;
    options.triangle_layer = layers;
    SelfContact contact({{0, 1, 2}, {3, 4, 5}}, {1e-4, 1.4e-4}, 6, options);
    contact.begin_step(start, 0.1);
    return support::gradient(contact, slid)[3][0];
  };
  const double usual = drag({}, {});
  EXPECT_GT(usual, 0);
  Eigen::MatrixXd mu(2, 2);
  mu << 0.9, 0.2, 0.2, 0.5;
  EXPECT_NEAR(drag(mu, {0, 1}), 0.5 * usual, 1e-12 * usual);
  EXPECT_NEAR(drag(mu, {0, 0}) * 0.5 / 0.9, drag(mu, {1, 1}), 1e-12 * usual);  // pairs of one layer
  EXPECT_THROW(drag(mu, {0, 2}), InvalidInput);
  mu(0, 1) = 0.3;
  EXPECT_THROW(drag(mu, {0, 1}), InvalidInput);
  mu << 0.9, -0.2, -0.2, 0.5;
  EXPECT_THROW(drag(mu, {0, 1}), InvalidInput);
}

TEST(SelfContact, AnchorsTrailThroughIterationsOnOneBalanceButNotThroughSteps) {
  const double reach = SelfContact::Options{}.stick_reach;
  const particles::VectorField start =
      over({0.008, 0.005, 1e-3}, {0.012, 0.02, 0.02}, {-0.01, 0.01, 0.03});
  const auto slid = [&](double reaches, double lift = 0) {
    particles::VectorField x = start;
    for (int i = 3; i < 6; ++i) x[i] += Vec3(reaches * reach, 0, lift);
    return x;
  };
  // Cloth that has slid too far and comes back half the way is still held back when it was an
  // iterate of one balance, and pushed the other way when the step before has ended.
  const auto drag = [&](double dt, int lost) {
    SelfContact contact = two_triangles(0.4);
    contact.begin_step(start, 0.1);
    contact.begin_step(slid(10), dt);
    for (int k = 0; k < lost; ++k) contact.begin_step(slid(10, 0.05), dt);
    contact.begin_step(slid(10), dt);
    return support::gradient(contact, slid(5))[3][0];
  };
  EXPECT_GT(drag(kStatic, 0), 0);
  EXPECT_GT(drag(kStatic, 10), 0);   // also through a lost contact
  EXPECT_LT(drag(kStatic, 100), 0);  // which is forgotten in the end
  EXPECT_LT(drag(0.1, 0), 0);
}

TEST(SelfContact, OneAndTwoThreadsGiveTheSameBits) {
  const geometry::TriangleMesh sheet = support::sheet(0.2, 0.2, 0.01, 0.2);
  geometry::TriangleMesh both = sheet;
  const int below = static_cast<int>(sheet.vertices.size());
  for (const Triangle& t : sheet.triangles)
    both.triangles.push_back({t[0] + below, t[1] + below, t[2] + below});
  for (const Vec3& p : sheet.vertices)
    both.vertices.push_back(p + Vec3(0.003, 0.002, 1e-3 * (1 + 0.5 * std::sin(90 * p[0]))));
  const std::vector<double> area(both.triangles.size(), 4e-5);
  std::vector<double> result[2];
  for (int k = 0; k < 2; ++k) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1 + k);
    SelfContact::Options options;
    options.thickness = kThickness;
    SelfContact contact(both.triangles, area, 2 * below, options);
    particles::VectorField x = both.vertices, dx(x.size());
    std::mt19937 rng(1);
    std::uniform_real_distribution<double> u(-1, 1);
    for (int step = 0; step < 6; ++step) {
      contact.begin_step(x, step < 3 ? 0.1 : kStatic);
      for (Vec3& d : dx) d = 3e-3 * Vec3(u(rng), u(rng), u(rng));
      const double share = contact.max_step(x, dx);
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += 0.5 * share * dx[i];
      particles::VectorField g(x.size(), Vec3::Zero());
      result[k].push_back(share);
      result[k].push_back(contact.value_and_gradient(x, g));
      for (const Vec3& f : g) result[k].insert(result[k].end(), f.data(), f.data() + 3);
      particles::BlockPattern pattern(2 * below);
      contact.add_pattern(x, pattern);
      pattern.compress();
      particles::BlockMatrix h(pattern);
      contact.add_hessian(x, h, particles::HessianKind::exact);
      for (const Mat3& b : h.blocks()) result[k].insert(result[k].end(), b.data(), b.data() + 9);
    }
    EXPECT_GT(contact.active(x), 1000);
  }
  ASSERT_EQ(result[0].size(), result[1].size());
  EXPECT_EQ(std::memcmp(result[0].data(), result[1].data(), result[0].size() * sizeof(double)), 0);
}

TEST(SelfContact, TakesUpAStateAgainWithItsFriction) {
  const particles::VectorField start =
      over({0.008, 0.005, 1e-3}, {0.012, 0.02, 0.02}, {-0.01, 0.01, 0.03});
  SelfContact contact = two_triangles(0.5);
  contact.begin_step(start, 0.1);
  particles::VectorField slid = start;
  for (int i = 3; i < 6; ++i) slid[i] += Vec3(5e-5, 0, 0);
  const auto kept = contact.memory();
  const auto force = [&](const SelfContact& c) {
    particles::VectorField g(slid.size(), Vec3::Zero());
    c.add_gradient(slid, g);
    return g;
  };
  const particles::VectorField before = force(contact);
  ASSERT_GT(before[3].head<2>().norm(), 0) << "friction";

  particles::VectorField apart = start;
  for (int i = 3; i < 6; ++i) apart[i] += Vec3(0, 0, 0.05);
  contact.begin_step(apart, 0.1);
  EXPECT_EQ(contact.active(slid), 0) << "forgotten";
  contact.recall(kept);
  EXPECT_EQ(force(contact), before);
  SelfContact other = two_triangles(0.5);
  other.recall(kept);
  EXPECT_EQ(force(other), before);
}

}  // namespace
}  // namespace loosefit::contact
