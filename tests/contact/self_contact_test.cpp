#include "loosefit/contact/self_contact.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "support/law_checker.h"
#include "support/shapes.h"

namespace loosefit {
namespace {

constexpr double kThickness = 2e-3;
constexpr double kStatic = std::numeric_limits<double>::infinity();

SelfContact two_triangles(double friction) {
  SelfContact::Options options;
  options.thickness = kThickness;
  options.friction = friction;
  return SelfContact({{0, 1, 2}, {3, 4, 5}}, {1e-4, 1.4e-4}, 6, options);
}

void expect_law(SelfContact& contact, const VectorField& x, const std::string& what) {
  SCOPED_TRACE(what);
  contact.begin_step(x, kStatic);
  EXPECT_GT(contact.active(x), 0);
  support::expect_derivatives(contact, x, 1e-8, 2e-5);
  support::expect_no_net_force_or_torque(contact, x);
}

/// Lower triangle in the plane z = 0, the upper one given by its corners.
VectorField over(const Vec3& a, const Vec3& b, const Vec3& c) {
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
    VectorField x(6);
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
    VectorField x = over({0.008, 0.005, 1e-3}, {0.012, 0.02, 0.02}, {-0.01, 0.01, 0.03});
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
    const VectorField x = over({0.008, 0.005, d}, {0.012, 0.02, 0.02}, {-0.01, 0.01, 0.03});
    contact.begin_step(x, kStatic);
    const double push = -support::gradient(contact, x)[3][2];
    EXPECT_GT(push, 0) << d;
    EXPECT_LT(push, last) << d;
    last = push;
  }
  SelfContact contact = two_triangles(0);
  const VectorField apart = over({0.008, 0.005, 2.01e-3}, {0.012, 0.02, 0.02}, {-0.01, 0.01, 0.03});
  contact.begin_step(apart, kStatic);
  EXPECT_EQ(contact.active(apart), 0);
  EXPECT_EQ(contact.value(apart), 0);
}

TEST(SelfContact, NeighboursInOneFlatSheetDoNotPushEachOther) {
  const TriangleMesh sheet = support::sheet(0.06, 0.06, 0.01, 0.15);
  std::vector<double> area(sheet.triangles.size(), 4e-5);
  SelfContact::Options options;
  options.thickness = 5e-4;
  SelfContact contact(sheet.triangles, area, static_cast<int>(sheet.vertices.size()), options);
  contact.begin_step(sheet.vertices, kStatic);
  EXPECT_EQ(contact.active(sheet.vertices), 0);
}

TEST(SelfContact, LimitsAStepThatWouldPassThrough) {
  SelfContact contact = two_triangles(0);
  const VectorField x = over({0.008, 0.005, 1e-3}, {0.012, 0.02, 0.02}, {-0.01, 0.01, 0.03});
  VectorField dx(6, Vec3::Zero());
  dx[3] = Vec3(0, 0, -0.01);
  const double share = contact.begin_search(x, dx);
  EXPECT_LT(share * 0.01, 1e-3);
  EXPECT_GT(share * 0.01, 0.8e-3);
  for (Vec3& d : dx) d = Vec3(0.3, -0.2, 0.1);
  EXPECT_EQ(contact.begin_search(x, dx), 1);
}

}  // namespace
}  // namespace loosefit
