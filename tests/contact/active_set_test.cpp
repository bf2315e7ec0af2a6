#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "loosefit/contact/body_contact.h"
#include "loosefit/contact/distance_field.h"
#include "loosefit/contact/self_contact.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "support/active_set_checker.h"
#include "support/shapes.h"

namespace loosefit::contact {
namespace {

constexpr particles::HessianKind kKinds[] = {particles::HessianKind::exact,
                                             particles::HessianKind::half_compression,
                                             particles::HessianKind::projected};
constexpr double kStatic = std::numeric_limits<double>::infinity();

/// Sheets that lie on each other, crumpled by less than the gap between them.
struct Layers {
  std::vector<Triangle> triangles;
  std::vector<double> area;
  particles::VectorField x;
  explicit Layers(double edge = 0.01) {
    std::mt19937 rng(5);
    std::uniform_real_distribution<double> u(-1, 1);
    for (int layer = 0; layer < 3; ++layer) {
      const geometry::TriangleMesh sheet = support::sheet(0.1, 0.1, edge, 0.2, 1 + layer);
      const int first = static_cast<int>(x.size());
      for (const Triangle& t : sheet.triangles) {
        triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
        area.push_back(4e-5);
      }
      for (const Vec3& p : sheet.vertices)
        x.push_back(p + Vec3(0, 0, 1.5e-3 * layer) + 2e-4 * Vec3(u(rng), u(rng), u(rng)));
    }
  }
  int particles() const { return static_cast<int>(x.size()); }
};

TEST(SelfContact, InAnActiveSetItsForcesAndStiffnessAreThoseOfTheWhole) {
  const Layers layers;
  SelfContact::Options options;
  options.thickness = 2e-3;
  SelfContact contact(layers.triangles, layers.area, layers.particles(), options);
  const particles::ActiveSet active_set = support::two_groups(layers.particles());
  contact.begin_step(layers.x, kStatic);
  ASSERT_GT(contact.active(layers.x), 100);
  for (particles::HessianKind kind : kKinds)
    EXPECT_GT(support::expect_same_in_active_set(contact, layers.x, active_set, 1e-4, kind), 0);
}

TEST(SelfContact, KeepsAllPairsThroughAnActiveSetWhoseParticlesMoveFar) {
  Layers layers;
  SelfContact::Options options;
  options.thickness = 2e-3;
  SelfContact contact(layers.triangles, layers.area, layers.particles(), options),
      fresh(layers.triangles, layers.area, layers.particles(), options);
  const particles::ActiveSet active_set = support::two_groups(layers.particles());
  particles::VectorField x = layers.x, dx(x.size(), Vec3::Zero());
  contact.begin_step(x, kStatic);
  fresh.begin_step(x, kStatic);
  contact.max_step(x, dx);
  contact.set_active_set(&active_set);
  for (int step = 0; step < 6; ++step) {
    for (int i : active_set.particles) dx[i] = Vec3(4e-3, step % 2 ? 2e-3 : -2e-3, 3e-4);
    const double share = contact.max_step(x, dx);
    for (int i : active_set.particles) x[i] += 0.5 * share * dx[i];
  }
  contact.set_active_set(nullptr);
  fresh.max_step(x, particles::VectorField(x.size(), Vec3::Zero()));
  particles::VectorField g(x.size(), Vec3::Zero()), expected = g;
  const double energy = fresh.value_and_gradient(x, expected);
  EXPECT_NEAR(contact.value_and_gradient(x, g), energy, 1e-9 * energy);
  double largest = 0, difference = 0;  // the guard of parallel edges knows where a search began
  for (std::size_t i = 0; i < x.size(); ++i) {
    largest = std::max(largest, expected[i].norm());
    difference = std::max(difference, (g[i] - expected[i]).norm());
  }
  EXPECT_LT(difference, 1e-9 * largest);
}

TEST(SelfContact, AnActiveSetForgetsNoBlocksOfTheOthers) {
  const Layers layers(0.007);
  SelfContact::Options options;
  options.thickness = 2e-3;
  options.friction = 0;
  SelfContact contact(layers.triangles, layers.area, layers.particles(), options);
  contact.begin_step(layers.x, kStatic);
  const auto blocks = [&] {
    particles::BlockPattern pattern(layers.particles());
    contact.add_pattern(layers.x, pattern);
    pattern.compress();
    std::size_t n = 0;
    for (const auto& rows : pattern.rows_of_column()) n += rows.size() - 1;
    return n;
  };
  const std::size_t all = blocks();
  ASSERT_GT(all, kContact.barrier.pattern_slack + 500);  // so many that most would be forgotten
  const auto version = contact.pattern_version(layers.x);
  particles::ActiveSet active_set{{5}, std::vector<char>(layers.x.size(), 0)};
  active_set.inside[5] = 1;
  contact.set_active_set(&active_set);
  EXPECT_EQ(contact.pattern_version(layers.x), version);
  EXPECT_EQ(blocks(), all);
  contact.set_active_set(nullptr);
  EXPECT_EQ(contact.pattern_version(layers.x), version);
}

TEST(CandidatePairs, InAnActiveSetAreThoseOfTheWholeThatTouchIt) {
  const Layers layers;
  const ContactFeatures features(layers.triangles, layers.area, layers.particles(), 2e-3, {}, {});
  CandidatePairs whole(features), part(features);
  const particles::ActiveSet active_set = support::two_groups(layers.particles());
  const auto expected = [&](const std::vector<FeaturePair>& pairs) {
    std::vector<std::uint64_t> keys;
    for (const FeaturePair& p : pairs)
      if (active_set.touches(p.particle, 4)) keys.push_back(p.key());
    return keys;
  };
  const auto keys = [](const std::vector<FeaturePair>& pairs) {
    std::vector<std::uint64_t> k;
    for (const FeaturePair& p : pairs) k.push_back(p.key());
    return k;
  };
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> u(-1, 1);
  particles::VectorField x = layers.x, dx(x.size(), Vec3::Zero());
  part.touching(x);
  part.set_active_set(&active_set);
  for (int call = 0; call < 12; ++call) {
    for (int i : active_set.particles)
      dx[i] = (call % 4 == 3 ? 5e-3 : 2e-4) * Vec3(u(rng), u(rng), u(rng));
    const auto approaching = expected(whole.approaching(x, dx));
    EXPECT_GT(approaching.size(), 100u);
    EXPECT_EQ(keys(part.approaching(x, dx)), approaching) << call;
    for (int i : active_set.particles) x[i] += dx[i];
    EXPECT_EQ(keys(part.touching(x)), expected(whole.touching(x))) << call;
  }
  part.set_active_set(nullptr);
  EXPECT_EQ(keys(part.touching(x)), keys(whole.touching(x)));
}

TEST(BodyContact, InAnActiveSetItsForcesAndStiffnessAreThoseOfTheWhole) {
  constexpr double kOffset = 2e-3;
  const geometry::TriangleMesh ball = support::sphere(0.05, 60, 120);
  const geometry::ClosestPointTree tree(ball);
  const auto field = std::make_shared<DistanceField>(
      tree, geometry::Box3(Vec3::Constant(-0.08), Vec3::Constant(0.08)), 0.005);
  // A shell round the ball, here and there pressed in.
  const geometry::TriangleMesh shell = support::sphere(0.05 + 0.7 * kOffset, 20, 30);
  particles::VectorField x = shell.vertices;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] *= 1 + 0.01 * std::sin(40.0 * i);
  const std::vector<double> area(shell.triangles.size(), 1e-5);
  BodyContact contact(contact_points(shell.triangles, area, static_cast<int>(x.size()), kOffset),
                      1e6, 0.4, 1e-4);
  contact.set_field(field);
  contact.begin_step(x, kStatic);
  particles::VectorField slid = x;
  for (Vec3& p : slid) p += 5e-5 * p.unitOrthogonal();
  contact.begin_step(slid, kStatic);
  const particles::ActiveSet active_set = support::two_groups(static_cast<int>(x.size()));
  for (particles::HessianKind kind : kKinds)
    EXPECT_GT(support::expect_same_in_active_set(contact, slid, active_set, 3e-4, kind), 0);
}

}  // namespace
}  // namespace loosefit::contact
