#include "loosefit/contact/body_contact.h"

#include <gtest/gtest.h>

#include <limits>

#include "loosefit/contact/distance_field.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "support/law_checker.h"
#include "support/shapes.h"

namespace loosefit::contact {
namespace {

constexpr double kStiffness = 1e6, kOffset = 2e-3, kReach = 1e-4;
constexpr double kStatic = std::numeric_limits<double>::infinity();

/// A sphere of 50 mm with its field, and a handful of cloth triangles at chosen depths around it.
struct Scene {
  geometry::TriangleMesh mesh = support::sphere(0.05, 60, 120);
  geometry::ClosestPointTree tree{mesh};
  std::shared_ptr<const DistanceField> field = std::make_shared<DistanceField>(
      tree, geometry::Box3(Vec3::Constant(-0.08), Vec3::Constant(0.08)), 0.005);
  std::vector<Triangle> triangles;
  std::vector<double> areas;
  particles::VectorField x;

  Scene() {
    std::mt19937 rng(2);
    std::normal_distribution<double> normal;
    // Compression of the vertices as a share of the offset: none, soft, hardening, full, beyond.
    const double shares[] = {-0.5, 0.2, 0.5, 0.7, 0.9, 1.3};
    for (int t = 0; t < 6; ++t) {
      const Vec3 n = Vec3(normal(rng), normal(rng), normal(rng)).normalized();
      const Vec3 e = n.unitOrthogonal(), f = n.cross(e);
      const int first = static_cast<int>(x.size());
      for (int k = 0; k < 3; ++k) {
        const double a = 2 * kPi * k / 3, share = shares[(t + 2 * k) % 6];
        const Vec3 direction = (n + 0.08 * (std::cos(a) * e + std::sin(a) * f)).normalized();
        x.push_back((0.05 + kOffset * (1 - share)) * direction);
      }
      triangles.push_back({first, first + 1, first + 2});
      areas.push_back(geometry::triangle_area(x[first], x[first + 1], x[first + 2]));
    }
  }

  BodyContact contact(double friction) const {
    BodyContact c(contact_points(triangles, areas, static_cast<int>(x.size()), kOffset), kStiffness,
                  friction, kReach);
    c.set_field(field);
    return c;
  }
};

TEST(BodyContact, ForceAndStiffnessAreDerivativesOfTheEnergy) {
  const Scene scene;
  BodyContact contact = scene.contact(0);
  EXPECT_GT(contact.active(scene.x), 20);
  support::expect_derivatives(contact, scene.x, 1e-8, 2e-5);
}

TEST(BodyContact, PointsBearAForceThatTheFieldSeesWithinTheOffset) {
  const Scene scene;
  const BodyContact contact = scene.contact(0.3);
  const std::vector<int> bearing = contact.bearing(scene.x);
  EXPECT_EQ(static_cast<int>(bearing.size()), contact.active(scene.x));
  std::vector<int> within;
  for (std::size_t i = 0; i < contact.points().size(); ++i)
    if (contact.field_distance(contact.points()[i], scene.x, 1) < kOffset)
      within.push_back(static_cast<int>(i));
  EXPECT_EQ(bearing, within);
  EXPECT_LT(bearing.size(), contact.points().size());
}

TEST(BodyContact, ForceWithFrictionIsTheDerivativeOfTheEnergyStickingAndSliding) {
  const Scene scene;
  for (double slide : {0.3 * kReach, 5 * kReach}) {
    BodyContact contact = scene.contact(0.4);
    contact.begin_step(scene.x, kStatic);
    particles::VectorField x = scene.x;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Vec3 t = x[i].normalized().unitOrthogonal();
      x[i] += slide * (1 + 0.1 * static_cast<double>(i % 5)) * t;
    }
    support::expect_derivatives(contact, x, 1e-8, 2e-5);
  }
}

TEST(BodyContact, DefiniteHessianIsDefinite) {
  const Scene scene;
  BodyContact contact = scene.contact(0.4);
  contact.begin_step(scene.x, kStatic);
  const Eigen::MatrixXd h =
      support::dense_hessian(contact, scene.x, particles::HessianKind::projected);
  const Eigen::VectorXd lambda = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(h).eigenvalues();
  EXPECT_GE(lambda.minCoeff(), -1e-10 * lambda.maxCoeff());
  EXPECT_GT(lambda.maxCoeff(), 0);
}

TEST(BodyContact, NormalForceIsTheMagnitudeOfTheFrictionlessForceAndKnowsNoFriction) {
  const Scene scene;
  BodyContact contact = scene.contact(0.4);
  contact.begin_step(scene.x, kStatic);
  particles::VectorField x = scene.x;
  for (Vec3& p : x) p += 5 * kReach * p.normalized().unitOrthogonal();
  std::vector<double> magnitude(x.size(), 0.0);
  contact.add_normal_force(x, magnitude);
  // A triangle here is so small that the normals of its corners differ by less than 0.16 rad: the
  // vector sum of the frictionless forces is all but the sum of the magnitudes.
  const particles::VectorField vector = support::gradient(scene.contact(0), x);
  double total = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_GE(magnitude[i], vector[i].norm() * (1 - 1e-12));
    EXPECT_NEAR(magnitude[i], vector[i].norm(), 0.01 * vector[i].norm());
    total += magnitude[i];
  }
  EXPECT_GT(total, 0);
  // One point alone: exactly area times the pressure of the layer.
  ContactPoint lone;
  lone.weight[0] = 1;
  lone.area = 3e-4;
  lone.offset = kOffset;
  BodyContact single({lone}, kStiffness, 0.4, kReach);
  single.set_field(scene.field);
  std::vector<double> force(1, 0.0);
  single.add_normal_force({{0.05 + 0.7 * kOffset, 0, 0}}, force);
  DistanceField::Sample at;
  ASSERT_TRUE(scene.field->sample({0.05 + 0.7 * kOffset, 0, 0}, 0.01, false, at));
  const double pressure = compress_layer(kStiffness, kOffset, kOffset - at.distance).pressure;
  EXPECT_NEAR(force[0], 3e-4 * pressure * at.gradient.norm(), 1e-12 * force[0]);
  EXPECT_NEAR(force[0], 3e-4 * compress_layer(kStiffness, kOffset, 0.3 * kOffset).pressure,
              0.05 * force[0]);
}

TEST(BodyContact, FrictionForceNeverExceedsTheConeAndReachesIt) {
  const Scene scene;
  const double mu = 0.4;
  for (double slide : {0.5 * kReach, 0.99 * kReach, 20 * kReach}) {
    BodyContact smooth = scene.contact(0), rough = scene.contact(mu);
    rough.begin_step(scene.x, kStatic);
    const particles::VectorField normal = support::gradient(smooth, scene.x);
    particles::VectorField x = scene.x;
    for (Vec3& p : x) p += slide * Vec3(0, 0, 1).cross(p).normalized();  // tangential everywhere
    const particles::VectorField without = support::gradient(smooth, x),
                                 with = support::gradient(rough, x);
    Vec3 sum = Vec3::Zero();
    double friction = 0, pressing = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      friction += (with[i] - without[i]).norm();
      pressing += normal[i].norm();
      sum += with[i] - without[i];
    }
    EXPECT_LE(friction, mu * pressing * 1.001) << slide;
    // Beyond the reach it slides with the full μλ; half way it carries s(2 − s) = 3/4 of it.
    const double s = std::min(1.0, slide / kReach);
    EXPECT_NEAR(friction, mu * pressing * s * (2 - s), 0.02 * mu * pressing) << slide;
  }
}

TEST(BodyContact, TakesUpAStateAgainWithItsPointsAndFriction) {
  const Scene scene;
  BodyContact contact = scene.contact(0.4);
  contact.change_points()[0].offset *= 1.5;
  contact.begin_step(scene.x, 0.1);
  particles::VectorField slid = scene.x;
  for (Vec3& p : slid) p += 0.5 * kReach * p.normalized().unitOrthogonal();
  const auto force = [&](const BodyContact& c) {
    particles::VectorField g(slid.size(), Vec3::Zero());
    c.add_gradient(slid, g);
    return g;
  };
  const particles::VectorField before = force(contact);
  const auto kept = contact.memory();
  contact.set_layer(0.5 * kOffset, 2 * kStiffness);
  contact.begin_step(slid, 0.1);
  EXPECT_NE(force(contact), before) << "another state";
  contact.recall(kept);
  EXPECT_EQ(force(contact), before);
}

TEST(BodyContact, PointsThatAreAddedPushAndThoseOfAKeptStateComeBackAfterAnActiveSet) {
  const Scene scene;
  BodyContact contact = scene.contact(0);
  const auto force = [&] {
    particles::VectorField g(scene.x.size(), Vec3::Zero());
    contact.add_gradient(scene.x, g);
    return g;
  };
  const particles::VectorField before = force();
  const auto kept = contact.memory();
  // A second set of the same points: everything pushes twice as hard.
  const std::vector<ContactPoint> points = contact.points();
  for (const ContactPoint& p : points) contact.change_points().push_back(p);
  const particles::VectorField twice = force();
  double largest = 0;
  for (std::size_t i = 0; i < twice.size(); ++i) {
    EXPECT_LT((twice[i] - 2 * before[i]).norm(), 1e-12 * before[i].norm());
    largest = std::max(largest, before[i].norm());
  }
  EXPECT_GT(largest, 0);
  particles::ActiveSet active_set{{0, 1}, std::vector<char>(scene.x.size(), 0)};
  active_set.inside[0] = active_set.inside[1] = 1;
  contact.set_active_set(&active_set);
  force();
  contact.set_active_set(nullptr);
  EXPECT_EQ(force(), twice);
  contact.recall(kept);
  EXPECT_EQ(force(), before);
}

TEST(Friction, KeepsItsAnchorAcrossStepsAndSlidesOnlyBeyondIt) {
  Friction friction(0.5, kReach);
  FrictionContact c;
  c.key = 7;
  c.weight = {1, 0, 0, 0};
  c.count = 1;
  c.normal_force = 2;
  particles::VectorField x = {Vec3::Zero()};
  const auto force = [&] {
    particles::VectorField g(1, Vec3::Zero());
    friction.add_gradient(x, g);
    return Vec3(-g[0]);
  };
  friction.restart({c}, x);
  EXPECT_EQ(force().norm(), 0);
  x[0] = Vec3(0.5 * kReach, 0, 0.3);  // the normal part does not count
  friction.restart({c}, x);
  EXPECT_NEAR(force()[0], -0.75 * 0.5 * 2, 1e-12);  // the spring survived the new step
  x[0][0] += 10 * kReach;
  EXPECT_NEAR(force()[0], -0.5 * 2, 1e-12);
  friction.restart({c}, x);
  EXPECT_NEAR(force()[0], -0.5 * 2, 1e-12);  // sliding: on the cone
  x[0][0] -= kReach;                         // back by the reach: the spring is slack
  EXPECT_NEAR(force().norm(), 0, 1e-12);
  friction.restart({}, x);  // lost contact forgets
  friction.restart({c}, x);
  EXPECT_EQ(force().norm(), 0);
}

TEST(Friction, IterationsOnOneBalanceTakeBackWhatSlidTooFar) {
  Friction friction(0.5, kReach);
  FrictionContact c;
  c.weight = {1, 0, 0, 0};
  c.count = 1;
  c.normal_force = 1;
  particles::VectorField x = {Vec3::Zero()};
  const auto force = [&] {
    particles::VectorField g(1, Vec3::Zero());
    friction.add_gradient(x, g);
    return Vec3(-g[0]);
  };
  friction.restart({c}, x);
  x[0][0] = 50 * kReach;  // too far, because the normal force lagged behind
  c.normal_force = 3;
  friction.iterate({c}, x);
  EXPECT_NEAR(force()[0], -0.5 * 3, 1e-12);
  EXPECT_EQ(friction.lagged_friction_force(), 0);
  friction.iterate({}, x);  // lifted off for a moment: a force that turns back is followed by half
  EXPECT_NEAR(force()[0], -0.5 * 1.5, 1e-12);
  EXPECT_NEAR(friction.lagged_friction_force(), 0.5 * 1.5, 1e-12);
  for (double share = 0.75; friction.lagged_friction_force() > 0;
       share = std::min(1.0, 1.5 * share)) {
    const double before = friction.lagged_friction_force();
    friction.iterate({}, x);  // it goes on that way: with growing shares, up to all of it
    EXPECT_NEAR(friction.lagged_friction_force(), (1 - share) * before, 1e-12);
  }
  EXPECT_EQ(force().norm(), 0);
  x[0][0] = 20 * kReach;
  for (int k = 0; k < 30; ++k) friction.iterate({c}, x);  // back for good
  EXPECT_EQ(friction.lagged_friction_force(), 0);
  EXPECT_NEAR(force()[0], -0.5 * 3, 1e-12);  // still held back: not a reversal of the slip
  friction.restart({c}, x);                  // the next step of the history is
  x[0][0] = 19 * kReach;
  EXPECT_NEAR(force().norm(), 0, 1e-12);
  // Farther than the memory the anchor follows.
  x[0][0] = 500 * kReach;
  friction.iterate({c}, x);
  x[0][0] = (500 - kContact.friction.memory) * kReach;
  EXPECT_NEAR(force().norm(), 0, 1e-12);
}

TEST(Friction, SlidingThereAndBackDissipates) {
  Friction friction(0.5, kReach);
  FrictionContact c;
  c.weight = {1, 0, 0, 0};
  c.count = 1;
  c.normal_force = 2;
  particles::VectorField x = {Vec3::Zero()};
  double work = 0;  // done on the contact
  const int n = 400;
  const double length = 100 * kReach;
  for (int i = 0; i < 2 * n; ++i) {
    friction.restart({c}, x);
    const double before = friction.value(x);
    x[0][0] += (i < n ? 1 : -1) * length / n;
    work += friction.value(x) - before;
  }
  // Twice the way times μλ, less the turning back of the spring.
  EXPECT_NEAR(work, 2 * length * 0.5 * 2, 0.03 * 2 * length);
}

}  // namespace
}  // namespace loosefit::contact
