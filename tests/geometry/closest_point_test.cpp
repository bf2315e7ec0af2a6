#include "loosefit/geometry/closest_point.h"

#include <gtest/gtest.h>

#include <random>

#include "support/shapes.h"

namespace loosefit {
namespace {

TEST(ClosestPointTree, AgreesWithBruteForceInsideOutsideAndOnTheSurface) {
  const TriangleMesh sphere = support::sphere(0.3, 48, 96);  // enough for a tree built in parallel
  const ClosestPointTree tree(sphere);
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> u(-0.5, 0.5);
  for (int i = 0; i < 400; ++i) {
    const Vec3 p = i % 10 == 0 ? sphere.vertices[i] : Vec3(u(rng), u(rng), u(rng));
    EXPECT_DOUBLE_EQ(tree.query(p).distance, closest_point_brute_force(sphere, p).distance);
  }
}

TEST(ClosestPointTree, SignedDistanceOfASphereIsRadiusMinusR) {
  const TriangleMesh sphere = support::sphere(0.3, 64, 128);
  const ClosestPointTree tree(sphere);
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> u(-0.5, 0.5);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p(u(rng), u(rng), u(rng));
    EXPECT_NEAR(tree.signed_distance(p), p.norm() - 0.3, 5e-4);
  }
}

TEST(ClosestPointTree, ReportsNothingBeyondTheSearchRadius) {
  const TriangleMesh sphere = support::sphere(0.3, 16, 32);
  EXPECT_EQ(ClosestPointTree(sphere).query(Vec3(1, 0, 0), 0.5).triangle, -1);
}

}  // namespace
}  // namespace loosefit
