#include "loosefit/contact/distance_field.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "support/shapes.h"

namespace loosefit::contact {
namespace {

geometry::Box3 box(double half) {
  return geometry::Box3(Vec3::Constant(-half), Vec3::Constant(half));
}

Vec3 random_direction(std::mt19937& rng) {
  std::normal_distribution<double> n;
  return Vec3(n(rng), n(rng), n(rng)).normalized();
}

class FieldOfSphere : public ::testing::TestWithParam<double> {};

TEST_P(FieldOfSphere, DistanceAndGradientAreThoseOfTheSphere) {
  const double radius = GetParam();
  const geometry::TriangleMesh mesh = support::sphere(radius, 90, 180);
  const geometry::ClosestPointTree tree(mesh);
  const DistanceField field(tree, box(radius + 0.02), 0.005);
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> depth(-0.003, 0.003);
  double worst = 0, worst_gradient = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 n = random_direction(rng);
    const double d = depth(rng);
    DistanceField::Sample s;
    ASSERT_TRUE(field.sample((radius + d) * n, 0.01, false, s));
    worst = std::max(worst, std::abs(s.distance - d));
    worst_gradient = std::max(worst_gradient, (s.gradient - n).norm());
  }
  EXPECT_LT(worst, 1e-4);
  EXPECT_LT(worst_gradient, 0.03);
  RecordProperty("worst_um", static_cast<int>(1e6 * worst));
  RecordProperty("worst_gradient_1e-4", static_cast<int>(1e4 * worst_gradient));
}

INSTANTIATE_TEST_SUITE_P(Radii, FieldOfSphere, ::testing::Values(0.025, 0.05, 0.15));

TEST(DistanceField, DistanceOfACylinder) {
  const geometry::TriangleMesh mesh = support::cylinder(0.03, -0.2, 0.2, 40, 200);
  const geometry::ClosestPointTree tree(mesh);
  const DistanceField field(tree, geometry::Box3(Vec3(-0.05, -0.05, -0.1), Vec3(0.05, 0.05, 0.1)),
                            0.005);
  double worst = 0;
  for (int i = 0; i < 500; ++i) {
    const double a = 0.1 + 2.399963 * i, d = -0.002 + 0.004 * (i % 17) / 16.0;
    const double z = -0.09 + 0.18 * (i % 101) / 100.0;
    DistanceField::Sample s;
    ASSERT_TRUE(
        field.sample(Vec3((0.03 + d) * std::cos(a), (0.03 + d) * std::sin(a), z), 0.01, false, s));
    worst = std::max(worst, std::abs(s.distance - d));
  }
  EXPECT_LT(worst, 1e-4);
  RecordProperty("worst_um", static_cast<int>(1e6 * worst));
}

TEST(DistanceField, DerivativesAreThoseOfTheInterpolant) {
  const geometry::TriangleMesh mesh = support::sphere(0.04, 40, 80);
  const geometry::ClosestPointTree tree(mesh);
  const DistanceField field(tree, box(0.06), 0.005);
  std::mt19937 rng(11);
  std::uniform_real_distribution<double> depth(-0.004, 0.004);
  const double h = 1e-6;
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = (0.04 + depth(rng)) * random_direction(rng);
    DistanceField::Sample s, plus, minus;
    ASSERT_TRUE(field.sample(p, 0.01, true, s));
    for (int c = 0; c < 3; ++c) {
      Vec3 up = p, down = p;
      up[c] += h;
      down[c] -= h;
      ASSERT_TRUE(field.sample(up, 0.01, false, plus));
      ASSERT_TRUE(field.sample(down, 0.01, false, minus));
      EXPECT_NEAR((plus.distance - minus.distance) / (2 * h), s.gradient[c], 2e-6);
      // The second derivative jumps at the faces of the grid; within 1e-6 m of one we may straddle.
      const Vec3 slope = (plus.gradient - minus.gradient) / (2 * h);
      EXPECT_LT((slope - s.hessian.col(c)).norm(), 5e-2 * (1 + s.hessian.norm()));
    }
  }
}

TEST(DistanceField, ExtremesOfThePositionAreAnswered) {
  const geometry::TriangleMesh mesh = support::sphere(0.10, 60, 120);
  const geometry::ClosestPointTree tree(mesh);
  const DistanceField field(tree, box(0.12), 0.005);
  DistanceField::Sample s;
  EXPECT_FALSE(field.sample(Vec3(0.13, 0, 0), 0.001, false, s));  // outside, on the grid
  EXPECT_FALSE(field.sample(Vec3(5, -3, 8), 0.001, false, s));    // off the grid
  // Deep inside, where the grid holds nothing: exact distance, gradient outwards.
  ASSERT_TRUE(field.sample(Vec3(0.03, 0, 0), 0.001, true, s));
  EXPECT_NEAR(s.distance, -0.07, 2e-4);
  EXPECT_GT(s.gradient[0], 0.99);
  ASSERT_TRUE(field.sample(Vec3(1e-9, 0, 0), 0.001, true, s));  // the centre
  EXPECT_NEAR(s.distance, -0.10, 5e-4);
  EXPECT_TRUE(s.gradient.allFinite());
}

TEST(DistanceField, BodyCutByTheRimOfTheGridKeepsInsideAndOutsideApart) {
  const geometry::TriangleMesh mesh = support::cylinder(0.05, -1, 1, 100, 96);
  const geometry::ClosestPointTree tree(mesh);
  // Both ends of the cylinder leave the region, as head and legs leave that of a shirt.
  const DistanceField field(tree, geometry::Box3(Vec3(-0.09, -0.09, -0.1), Vec3(0.09, 0.09, 0.1)),
                            0.005);
  DistanceField::Sample s;
  for (double z : {-0.12, -0.05, 0.0, 0.05, 0.12})
    for (int i = 0; i < 16; ++i) {
      const Vec3 n(std::cos(0.2 + i), std::sin(0.2 + i), 0);
      ASSERT_TRUE(field.sample(0.01 * n + Vec3(0, 0, z), 0.001, false, s)) << z;
      EXPECT_NEAR(s.distance, -0.04, 3e-4);
      EXPECT_FALSE(field.sample(0.08 * n + Vec3(0, 0, z), 0.001, false, s)) << z;
      ASSERT_TRUE(field.sample(0.0495 * n + Vec3(0, 0, z), 0.001, false, s)) << z;
      EXPECT_NEAR(s.distance, -0.0005, 1e-4);
    }
  // Off the grid the surface itself answers.
  ASSERT_TRUE(field.sample(Vec3(0.0495, 0, 0.5), 0.001, false, s));
  EXPECT_NEAR(s.distance, -0.0005, 1e-4);
}

TEST(DistanceField, ReachDecidesWhatIsTouched) {
  const geometry::TriangleMesh mesh = support::sphere(0.10, 60, 120);
  const geometry::ClosestPointTree tree(mesh);
  const DistanceField field(tree, box(0.12), 0.005);
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> depth(0, 0.02);
  for (double reach : {0.00025, 0.002, 0.006})
    for (int i = 0; i < 500; ++i) {
      const double d = depth(rng);
      if (std::abs(d - reach) < 1e-4) continue;  // within the error of the field
      DistanceField::Sample s;
      EXPECT_EQ(field.sample((0.10 + d) * random_direction(rng), reach, false, s), d < reach) << d;
    }
}

/// Many small spheres near each other: creases of the distance in every cell.
geometry::TriangleMesh pebbles() {
  geometry::TriangleMesh all;
  for (int i = 0; i < 125; ++i) {
    geometry::TriangleMesh one = support::sphere(0.004, 8, 12);
    const Vec3 centre = 0.011 * Vec3(i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2) +
                        0.001 * Vec3(std::sin(7 * i), std::sin(11 * i), std::sin(13 * i));
    const int first = static_cast<int>(all.vertices.size());
    for (const Vec3& p : one.vertices) all.vertices.push_back(p + centre);
    for (Triangle t : one.triangles)
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return all;
}

TEST(DistanceField, WhatItCallsFarIsFarByItsInterpolantToo) {
  const geometry::TriangleMesh mesh = pebbles();
  const geometry::ClosestPointTree tree(mesh);
  const DistanceField field(tree, box(0.04));
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> at(-0.032, 0.032);
  int asked = 0;
  for (int i = 0; i < 200000; ++i) {
    const Vec3 p(at(rng), at(rng), at(rng));
    DistanceField::Sample here;
    if (!field.sample(p, 0.1, false, here)) continue;
    const double reach = here.distance + 1e-6;  // just touched, if nobody is hasty
    DistanceField::Sample again;
    ASSERT_TRUE(field.sample(p, reach, false, again)) << p.transpose();
    ++asked;
  }
  EXPECT_GT(asked, 100000);
}

// Contact would stop where its energy jumps: up to the smooth reach nothing does.
TEST(DistanceField, HasNoJumpsUpToItsSmoothReach) {
  geometry::TriangleMesh wedge = support::sphere(0.05, 40, 80);
  for (Vec3& p : wedge.vertices) p[2] *= 0.3;  // a lens with a sharp rim
  const geometry::ClosestPointTree tree(wedge);
  const DistanceField field(tree, box(0.08));
  const double reach = field.smooth_reach();
  EXPECT_GT(reach, 0.010);
  std::mt19937 rng(11);
  double worst = 0;
  for (int i = 0; i < 60; ++i) {
    const Vec3 way = random_direction(rng);
    double before = -1;
    for (int k = 0; k <= 20000; ++k) {
      DistanceField::Sample s;
      const double d = field.sample((0.01 + 3e-6 * k) * way, reach, false, s) ? s.distance : reach;
      if (k > 0) worst = std::max(worst, std::abs(d - before));
      before = d;
    }
  }
  EXPECT_LT(worst, 3e-6 * DistanceField::kSteepest);
}

TEST(DistanceField, KnowsWhatItCovers) {
  const geometry::TriangleMesh ball = support::sphere(0.04, 20, 40);
  const geometry::ClosestPointTree tree(ball);
  const DistanceField field(tree, box(0.06));
  EXPECT_TRUE(field.covers(box(0.06)));
  EXPECT_FALSE(field.covers(box(0.09)));
}

// Two balls that touch, the second only as a cover: the field is that of both together.
TEST(DistanceField, CoversHideTheBodyInThem) {
  const geometry::TriangleMesh ball = support::sphere(0.04, 60, 120);
  geometry::TriangleMesh cover = ball;
  for (Vec3& p : cover.vertices) p[0] += 0.06;
  const geometry::ClosestPointTree tree(ball);
  const DistanceField field(tree, geometry::Box3(Vec3::Constant(-0.06), Vec3(0.12, 0.06, 0.06)),
                            0.005, {cover, geometry::TriangleMesh{}});
  const auto at = [&](const Vec3& p) {
    DistanceField::Sample s;
    field.sample(p, 0.02, false, s);
    return s.distance;
  };
  EXPECT_NEAR(at({-0.042, 0, 0}), 0.002, 1e-4);
  EXPECT_NEAR(at({0.103, 0, 0}), 0.003, 1e-4);
  EXPECT_NEAR(at({0.06, 0, 0.041}), 0.001, 1e-4);
  EXPECT_LT(at({0.03, 0, 0}), -0.009);
}

// Nodes are measured when they are asked for: by whom, and in which order, must not show.
TEST(DistanceField, OrderAndThreadsDoNotChangeABit) {
  const geometry::TriangleMesh ball = support::sphere(0.04, 40, 80);
  const geometry::ClosestPointTree tree(ball);
  std::mt19937 rng(7);
  std::uniform_real_distribution<double> depth(-0.01, 0.012);
  std::vector<Vec3> places(4000);
  for (Vec3& p : places) p = (0.04 + depth(rng)) * random_direction(rng);
  const auto distances = [&](bool backwards, bool parallel) {
    const DistanceField field(tree, box(0.06), 0.005);
    std::vector<double> d(places.size());
    const auto ask = [&](std::size_t i) {
      DistanceField::Sample s;
      field.sample(places[i], 0.02, false, s);
      d[i] = s.distance;
    };
    if (parallel)
      tbb::parallel_for(std::size_t{0}, places.size(), ask);
    else
      for (std::size_t i = 0; i < places.size(); ++i) ask(backwards ? places.size() - 1 - i : i);
    return d;
  };
  const std::vector<double> once = distances(false, false);
  EXPECT_EQ(distances(true, false), once);
  EXPECT_EQ(distances(false, true), once);
}

}  // namespace
}  // namespace loosefit::contact
