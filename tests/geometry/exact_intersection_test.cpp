#include "loosefit/geometry/exact_intersection.h"

#include <gtest/gtest.h>

#include <random>

#include "loosefit/geometry/box_pairs.h"
#include "support/shapes.h"

namespace loosefit::geometry {
namespace {

TEST(ExactIntersection, CrossingTrianglesAreFoundAndSeparatedOnesAreNot) {
  const std::vector<Vec3> x = {{0, 0, 0},      {1, 0, 0},     {0, 1, 0},
                               {0.2, 0.2, -1}, {0.2, 0.2, 1}, {2, 2, 0.5}};
  EXPECT_EQ(self_intersections(x, {{0, 1, 2}, {3, 4, 5}}).size(), 1u);
  std::vector<Vec3> apart = x;
  for (int i = 3; i < 6; ++i) apart[i] += Vec3(3, 0, 0);
  EXPECT_TRUE(self_intersections(apart, {{0, 1, 2}, {3, 4, 5}}).empty());
}

TEST(ExactIntersection, TouchingByOneUlpIsDecidedExactly) {
  const double above = std::nextafter(0.0, 1.0);
  const std::vector<Vec3> base = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<Vec3> hovering = {{0.1, 0.1, above}, {0.5, 0.1, above}, {0.1, 0.5, 1}};
  const std::vector<Vec3> touching = {{0.1, 0.1, 0}, {0.5, 0.1, 1}, {0.1, 0.5, 1}};
  EXPECT_TRUE(mesh_intersections(base, {{0, 1, 2}}, hovering, {{0, 1, 2}}).empty());
  EXPECT_EQ(mesh_intersections(base, {{0, 1, 2}}, touching, {{0, 1, 2}}).size(), 1u);
}

TEST(ExactIntersection, NeighboursThatShareAVertexCountOnlyWhenTheyPierce) {
  const std::vector<Vec3> flat = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  EXPECT_TRUE(self_intersections(flat, {{0, 1, 2}, {0, 3, 4}}).empty());
  const std::vector<Vec3> piercing = {
      {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, -1}, {0.3, 0.3, 1}};
  EXPECT_EQ(self_intersections(piercing, {{0, 1, 2}, {0, 3, 4}}).size(), 1u);
}

TEST(ExactIntersection, OfSomeTrianglesAreThosePairsOfAllThatHaveOneOfThem) {
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> u(-0.2, 0.2), size(-0.05, 0.05);
  std::vector<Vec3> x;
  std::vector<Triangle> triangles;
  std::vector<char> wanted;
  for (int i = 0; i < 400; ++i) {
    const Vec3 p(u(rng), u(rng), u(rng));
    for (int k = 0; k < 3; ++k) x.push_back(p + Vec3(size(rng), size(rng), size(rng)));
    const int shared = i % 3 == 0 && i > 0 ? 3 * i - 3 : 3 * i;  // with the one before
    triangles.push_back({shared, 3 * i + 1, 3 * i + 2});
    wanted.push_back(i % 5 < 2);
  }
  std::vector<std::pair<int, int>> expected;
  for (const auto& [i, j] : self_intersections(x, triangles))
    if (wanted[i] || wanted[j]) expected.emplace_back(i, j);
  EXPECT_GE(expected.size(), 20u);
  EXPECT_EQ(self_intersections(x, triangles, wanted), expected);
}

TEST(ExactIntersection, CoplanarTrianglesAndDegenerateOnesAreDecidedAsWithoutAQuickNo) {
  // In one slanted plane, up to round-off: side by side, overlapping, and a side that lies in one.
  const auto at = [](double u, double v) { return Vec3(0.1 + u, 0.2 + v, 0.3 * u + 0.7 * v); };
  const std::vector<Vec3> x = {at(0, 0), at(1, 0), at(0, 1),  at(0.2, 0.2), at(1.2, 0.2), at(2, 2),
                               at(3, 2), at(2, 3), {0, 0, 5}, {0, 0, 6},    {0, 0, 7}};
  EXPECT_TRUE(self_intersections(x, {{0, 1, 2}, {5, 6, 7}}).empty());
  const std::vector<Vec3> flat = {{0, 0, 1},     {1, 0, 1},     {0, 1, 1},     {0.2, 0.2, 1},
                                  {1.2, 0.2, 1}, {0.2, 1.2, 1}, {0.3, 0.3, 0}, {0.3, 0.3, 2}};
  EXPECT_EQ(self_intersections(flat, {{0, 1, 2}, {3, 4, 5}}).size(), 1u);
  EXPECT_EQ(self_intersections(flat, {{0, 1, 2}, {6, 7, 6}}).size(), 1u);
  EXPECT_TRUE(self_intersections(x, {{0, 1, 2}, {8, 9, 10}}).empty());
}

TEST(ExactIntersection, WithATreeTheSamePairsAreFoundAsWithout) {
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> u(-0.4, 0.4), size(-0.05, 0.05);
  std::vector<Vec3> x;
  std::vector<Triangle> triangles;
  for (int i = 0; i < 300; ++i) {
    const Vec3 p(u(rng), u(rng), u(rng));
    for (int k = 0; k < 3; ++k) x.push_back(p + Vec3(size(rng), size(rng), size(rng)));
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    if (i % 50 == 0) triangles.push_back({3 * i, 3 * i + 1, 3 * i});  // a side, no area
  }
  for (const TriangleMesh& surface : {support::sphere(0.3, 24, 48), TriangleMesh{x, {{0, 1, 2}}}}) {
    const auto expected = mesh_intersections(x, triangles, surface.vertices, surface.triangles);
    EXPECT_GE(expected.size(), 1u);
    EXPECT_EQ(mesh_intersections(x, triangles, ClosestPointTree(surface)), expected);
  }
}

TEST(BoxPairs, GridAgreesWithBruteForceOnRandomBoxes) {
  std::mt19937 rng(7);
  std::uniform_real_distribution<double> position(-1, 1), size(0.001, 0.2);
  std::vector<Box3> boxes(300);
  for (Box3& b : boxes) {
    const Vec3 p(position(rng), position(rng), position(rng));
    b = Box3(p, p + Vec3(size(rng), size(rng), size(rng)));
  }
  std::vector<std::pair<int, int>> expected;
  for (int i = 0; i < 300; ++i)
    for (int j = i + 1; j < 300; ++j)
      if (boxes[i].intersects(boxes[j])) expected.emplace_back(i, j);
  EXPECT_GT(expected.size(), 20u);
  EXPECT_EQ(overlapping_boxes(boxes), expected);
  // The same by asking for each box alone.
  std::vector<std::pair<int, int>> both;
  for (const auto& [i, j] : overlapping_boxes(boxes, boxes))
    if (i < j) both.emplace_back(i, j);
  EXPECT_EQ(both, expected);
}

TEST(BoxPairs, BoxesInOnePlaceAndBoxesThatJustTouchAreFound) {
  const Box3 unit(Vec3::Zero(), Vec3::Ones());
  const Box3 beside(Vec3(1, 0, 0), Vec3(2, 1, 1));
  const Box3 apart(Vec3(2 + 1e-9, 0, 0), Vec3(3, 1, 1));
  using Pairs = std::vector<std::pair<int, int>>;
  EXPECT_EQ(overlapping_boxes({unit, unit, beside, apart}), (Pairs{{0, 1}, {0, 2}, {1, 2}}));
  EXPECT_EQ(overlapping_boxes({unit}, {beside, apart}), (Pairs{{0, 0}}));
  EXPECT_TRUE(overlapping_boxes({}).empty());
  EXPECT_TRUE(overlapping_boxes({unit}, {}).empty());
}

}  // namespace
}  // namespace loosefit::geometry
