#include "loosefit/geometry/flat_triangle.h"

#include <gtest/gtest.h>

#include <cmath>

namespace loosefit::geometry {
namespace {

const FlatCorners kFlat = {Vec2(1, 1), Vec2(5, 1), Vec2(1, 4)};

TEST(FlatTriangle, AreaAndHeightDoNotDependOnTheWayRound) {
  const FlatCorners turned = {kFlat[0], kFlat[2], kFlat[1]};
  EXPECT_DOUBLE_EQ(flat_area(kFlat), 6);
  EXPECT_DOUBLE_EQ(flat_area(turned), 6);
  EXPECT_EQ(flat_areas({kFlat, turned}), (std::vector<double>{6, 6}));
  // Twice the area over the longest edge, 3-4-5.
  EXPECT_DOUBLE_EQ(shortest_height({kFlat}), 12.0 / 5);
  EXPECT_DOUBLE_EQ(shortest_height({turned}), 12.0 / 5);
}

TEST(FlatTriangle, CrossIsPositiveCounterClockwise) {
  EXPECT_EQ(cross(Vec2(2, 0), Vec2(0, 3)), 6);
  EXPECT_EQ(cross(Vec2(0, 3), Vec2(2, 0)), -6);
}

TEST(DeformationGradient, IsTheMapThatTookTheCornersThere) {
  DeformationGradient f;
  f << 1.1, 0.2, -0.3, 0.9, 0.05, 0.4;
  std::vector<Vec3> positions;
  for (const Vec2& corner : kFlat) positions.push_back(f * corner + Vec3(7, 8, 9));
  EXPECT_LT((deformation_gradient(kFlat, {0, 1, 2}, positions) - f).norm(), 1e-14);
}

TEST(DeformationGradient, OfNoAreaIsNotANumber) {
  const std::vector<Vec3> positions(3, Vec3::Zero());
  const FlatCorners line = {Vec2(0, 0), Vec2(1, 1), Vec2(2, 2)};
  EXPECT_TRUE(deformation_gradient(line, {0, 1, 2}, positions).array().isNaN().all());
}

}  // namespace
}  // namespace loosefit::geometry
