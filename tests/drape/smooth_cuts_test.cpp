#include "loosefit/drape/smooth_cuts.h"

#include <gtest/gtest.h>

#include "loosefit/geometry/exact_intersection.h"

namespace loosefit::drape {
namespace {

/// A square of 20 × 20 cells of 1 cm at z = 0, corner at the origin.
struct Sheet {
  static constexpr int kCells = 20;
  std::vector<Vec3> x;
  std::vector<Triangle> triangles;
  static int at(int i, int j) { return i * (kCells + 1) + j; }
  Sheet() {
    for (int i = 0; i <= kCells; ++i)
      for (int j = 0; j <= kCells; ++j) x.emplace_back(0.01 * i, 0.01 * j, 0);
    for (int i = 0; i < kCells; ++i)
      for (int j = 0; j < kCells; ++j) {
        triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
};

/// A box whose top is at this height, under the sheet and wider than it.
geometry::TriangleMesh box_below(double top) {
  geometry::TriangleMesh box;
  for (double z : {-0.5, top})
    for (double y : {-0.5, 0.7})
      for (double x : {-0.5, 0.7}) box.vertices.emplace_back(x, y, z);
  box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return box;
}

TEST(SmoothCuts, ALoopThatPassesThroughTheSheetComesOut) {
  Sheet sheet;
  // A vertex that is drawn through the sheet three cells away.
  sheet.x[Sheet::at(10, 10)] = Vec3(0.135, 0.133, -0.004);
  sheet.x[Sheet::at(10, 11)] = Vec3(0.135, 0.137, 0.004);
  ASSERT_FALSE(geometry::self_intersections(sheet.x, sheet.triangles).empty());
  const std::vector<Vec3> before = sheet.x;
  const geometry::TriangleMesh box = box_below(-0.1);
  const geometry::ClosestPointTree skin(box);
  const SmoothedCuts smoothed = smooth_cuts(sheet.x, sheet.triangles, skin, 0.002, 40);
  EXPECT_GT(smoothed.first_cuts, 0);
  EXPECT_EQ(smoothed.cuts, 0);
  EXPECT_EQ(smoothed.first_cut.first, -1);
  EXPECT_TRUE(geometry::self_intersections(smoothed.x, sheet.triangles).empty());
  EXPECT_EQ(smoothed.x[Sheet::at(0, 0)], before[Sheet::at(0, 0)]) << "what is far off stays";
}

TEST(SmoothCuts, EndsAfterSoManyRoundsWithWhatIsLeft) {
  Sheet sheet;
  sheet.x[Sheet::at(10, 10)] = Vec3(0.135, 0.133, -0.004);
  sheet.x[Sheet::at(10, 11)] = Vec3(0.135, 0.137, 0.004);
  const geometry::TriangleMesh box = box_below(-0.1);
  const geometry::ClosestPointTree skin(box);
  const SmoothedCuts smoothed = smooth_cuts(sheet.x, sheet.triangles, skin, 0.002, 0);
  EXPECT_EQ(smoothed.cuts, smoothed.first_cuts);
  EXPECT_EQ(smoothed.x, sheet.x);
  EXPECT_GE(smoothed.first_cut.first, 0);
}

}  // namespace
}  // namespace loosefit::drape
