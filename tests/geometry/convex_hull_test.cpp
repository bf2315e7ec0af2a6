#include "loosefit/geometry/convex_hull.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

#include "loosefit/geometry/closest_point_tree.h"
#include "support/shapes.h"

namespace loosefit::geometry {
namespace {

TEST(ConvexHull, OfABoxWithThingsInItIsTheBoxOrientedOutwards) {
  std::vector<Vec3> points;
  for (double x : {-1.0, 0.2, 1.0})
    for (double y : {-2.0, 0.1, 2.0})
      for (double z : {-3.0, 0.0, 3.0}) points.emplace_back(x, y, z);
  const TriangleMesh hull = convex_hull(points);
  double volume = 0;
  for (const auto& [a, b, c] : hull.triangles)
    volume += hull.vertices[a].dot(hull.vertices[b].cross(hull.vertices[c])) / 6;
  EXPECT_NEAR(volume, 2 * 4 * 6, 1e-12);
  const ClosestPointTree tree(hull);
  EXPECT_NEAR(tree.signed_distance(Vec3(0.5, 0, 0)), -0.5, 1e-12);
  EXPECT_NEAR(tree.signed_distance(Vec3(0, 0, 4)), 1, 1e-12);
}

TEST(ConvexHull, OfASphereIsTheSphere) {
  const TriangleMesh ball = support::sphere(0.1, 12, 24);
  EXPECT_EQ(convex_hull(ball.vertices).vertices.size(), ball.vertices.size());
}

// A hull whose triangles come in another order gives distances with other last bits, from which
// drapes part ways.
TEST(ConvexHull, DoesNotDependOnTheOrderOfThePoints) {
  std::mt19937 random(5);
  std::normal_distribution<double> along;
  std::vector<Vec3> points(300);
  for (Vec3& p : points) p = Vec3(along(random), along(random), along(random)).normalized();
  const TriangleMesh hull = convex_hull(points);
  ASSERT_EQ(hull.vertices.size(), points.size());
  for (int k = 0; k < 5; ++k) {
    std::shuffle(points.begin(), points.end(), random);
    const TriangleMesh again = convex_hull(points);
    EXPECT_TRUE(again.vertices == hull.vertices);
    EXPECT_TRUE(again.triangles == hull.triangles);
  }
}

TEST(ConvexHull, OfFewOrFlatPointsIsEmpty) {
  EXPECT_TRUE(convex_hull({}).triangles.empty());
  EXPECT_TRUE(convex_hull({Vec3(1, 2, 3)}).triangles.empty());
  EXPECT_TRUE(
      convex_hull({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}).triangles.empty());
}

}  // namespace
}  // namespace loosefit::geometry
