#include "loosefit/geometry/folded_edges.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/geometry/exact_intersection.h"

namespace loosefit::geometry {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

/// Two triangles of that height [m] at an edge; the second leans from the first by `angle` [rad], 0
/// folded back on it, π flat.
std::vector<Vec3> book(double angle, double height = 0.004) {
  return {{0, 0, 0},
          {0, height, 0},
          {height, 0.5 * height, 0},
          {height * std::cos(angle), 0.3 * height, height * std::sin(angle)}};
}
const std::vector<Triangle> kBook = {{0, 2, 1}, {0, 1, 3}};

TEST(FoldedEdges, OfSmallTrianglesAreThoseBelowTheAngle) {
  for (double degree : {0.0, 0.1, 0.23}) {
    EXPECT_EQ(folded_edges(book(radians(degree)), kBook), (Pairs{{0, 1}})) << degree;
    EXPECT_EQ(folded_edges(book(radians(-degree)), kBook), (Pairs{{0, 1}})) << degree;
  }
  for (double degree : {0.27, 5.0, 90.0, 179.9, 180.0})
    EXPECT_TRUE(folded_edges(book(radians(degree)), kBook).empty()) << degree;
}

// The free corner lies height · sin(angle) from the other triangle.
TEST(FoldedEdges, OfLargeTrianglesAreThoseBelowTheDistance) {
  for (double height : {0.006, 0.02, 1.0}) {
    EXPECT_EQ(folded_edges(book(1.9e-5 / height, height), kBook).size(), 1u) << height;
    EXPECT_TRUE(folded_edges(book(2.1e-5 / height, height), kBook).empty()) << height;
  }
}

// The nearer corner alone says nothing: that of a narrow triangle always lies near.
TEST(FoldedEdges, AreToldByTheFartherCorner) {
  std::vector<Vec3> x = book(2.1e-5 / 0.02, 0.02);
  x[3] *= 0.1;
  EXPECT_TRUE(folded_edges(x, kBook).empty());
}

TEST(FoldedEdges, AreWhatTheTestForIntersectionsLeavesOut) {
  EXPECT_TRUE(self_intersections(book(0), kBook).empty());
  EXPECT_EQ(folded_edges(book(0), kBook).size(), 1u);
}

TEST(FoldedEdges, DoNotDependOnThePlace) {
  std::vector<Vec3> x = book(radians(0.2));
  for (Vec3& p : x) p += Vec3(0.3, -1, 2);
  EXPECT_EQ(folded_edges(x, kBook).size(), 1u);
}

TEST(FoldedEdges, TrianglesWithoutAreaAreNotJudged) {
  std::vector<Vec3> x = book(0);
  x[3] = {0, 0.002, 0};
  EXPECT_TRUE(folded_edges(x, kBook).empty());
}

}  // namespace
}  // namespace loosefit::geometry
