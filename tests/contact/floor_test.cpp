#include "loosefit/contact/floor.h"

#include <gtest/gtest.h>

#include <random>

#include "loosefit/contact/body_contact.h"
#include "support/law_checker.h"

namespace loosefit::contact {
namespace {

constexpr double kOffset = 1e-3, kStiffness = 1e6, kHeight = -0.37;

/// Points of their own above, within and below the layer on a floor, each for `area`.
BodyContact points_on_floor(int count, double area, double friction) {
  std::vector<ContactPoint> points(count);
  for (int i = 0; i < count; ++i) {
    points[i].particle[0] = i, points[i].weight[0] = 1;
    points[i].area = area, points[i].offset = kOffset;
  }
  BodyContact contact(points, kStiffness, friction, 1e-4);
  contact.set_field(std::make_shared<Floor>(kHeight));
  return contact;
}

TEST(Floor, ForceAndStiffnessAreDerivativesOfTheEnergy) {
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> across(-1, 1), above(-0.4 * kOffset, 1.5 * kOffset);
  particles::VectorField x;
  for (int i = 0; i < 12; ++i) x.emplace_back(across(rng), across(rng), kHeight + above(rng));
  BodyContact contact = points_on_floor(12, 2e-4, 0);
  EXPECT_GT(contact.active(x), 4);
  EXPECT_LT(contact.active(x), 12);
  support::expect_derivatives(contact, x, 1e-8, 2e-5);
}

TEST(Floor, PushesUpHoweverDeepAndNothingTouchesWithoutIt) {
  const particles::VectorField x = {{0.3, 0.2, kHeight - 0.08}, {0, 0, kHeight + 2 * kOffset}};
  BodyContact contact = points_on_floor(2, 1e-4, 0);
  particles::VectorField g(2, Vec3::Zero());
  contact.add_gradient(x, g);
  EXPECT_LT(g[0].z(), -1e-2);
  EXPECT_EQ(g[0].head<2>().norm(), 0);
  EXPECT_EQ(g[1].norm(), 0);
  contact.set_field(nullptr);
  EXPECT_EQ(contact.active(x), 0);
  EXPECT_EQ(contact.value(x), 0);
}

TEST(Floor, FrictionHoldsAPushUpToItsShareOfTheLoad) {
  const double mu = 0.4;
  BodyContact contact = points_on_floor(1, 1e-4, mu);
  particles::VectorField x = {{0, 0, kHeight + 0.5 * kOffset}};
  contact.begin_step(x, 0.01);
  std::vector<double> load(1, 0);
  contact.add_normal_force(x, load);
  x[0].x() += 0.01;
  contact.begin_step(x, std::numeric_limits<double>::infinity());
  particles::VectorField g(1, Vec3::Zero());
  contact.add_friction(x, g);
  EXPECT_NEAR(g[0].x(), mu * load[0], 1e-3 * mu * load[0]);
}

}  // namespace
}  // namespace loosefit::contact
