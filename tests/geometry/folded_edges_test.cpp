#include "loosefit/geometry/folded_edges.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/geometry/exact_intersection.h"

namespace loosefit::geometry {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

/// Two triangles at the edge from the origin to (0, 1, 0); the second leans from the first by
/// `angle` [rad], 0 folded back on it, π flat.
std::vector<Vec3> book(double angle) {
  return {{0, 0, 0}, {0, 1, 0}, {1, 0.5, 0}, {std::cos(angle), 0.3, std::sin(angle)}};
}
const std::vector<Triangle> kBook = {{0, 2, 1}, {0, 1, 3}};

TEST(FoldedEdges, AreThoseBelowTheAngleAndNoOthers) {
  for (double degree : {0.0, 0.1, 0.23}) {
    EXPECT_EQ(folded_edges(book(radians(degree)), kBook), (Pairs{{0, 1}})) << degree;
    EXPECT_EQ(folded_edges(book(radians(-degree)), kBook), (Pairs{{0, 1}})) << degree;
  }
  for (double degree : {0.27, 5.0, 90.0, 179.9, 180.0})
    EXPECT_TRUE(folded_edges(book(radians(degree)), kBook).empty()) << degree;
}

TEST(FoldedEdges, AreWhatTheTestForIntersectionsLeavesOut) {
  EXPECT_TRUE(self_intersections(book(0), kBook).empty());
  EXPECT_EQ(folded_edges(book(0), kBook).size(), 1u);
}

TEST(FoldedEdges, DoNotDependOnTheSizeOfTheTriangles) {
  for (double scale : {1e-6, 1e3}) {
    std::vector<Vec3> x = book(radians(0.2));
    for (Vec3& p : x) p = scale * p + Vec3(0.3, -1, 2);
    EXPECT_EQ(folded_edges(x, kBook).size(), 1u) << scale;
  }
}

TEST(FoldedEdges, TrianglesWithoutAreaAreNotJudged) {
  std::vector<Vec3> x = book(0);
  x[3] = {0, 0.5, 0};
  EXPECT_TRUE(folded_edges(x, kBook).empty());
}

}  // namespace
}  // namespace loosefit::geometry
