#include "loosefit/render/smooth_solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace loosefit::render {
namespace {

/// Points on an ellipsoid at the origin, with two horns.
std::vector<Vec3> horned(const Vec3& half) {
  std::vector<Vec3> points;
  for (int i = 0; i < 40; ++i)
    for (int j = 1; j < 20; ++j) {
      const double a = 2 * kPi * (i + 0.01 * j) / 40, b = kPi * j / 20;
      points.push_back(half.cwiseProduct(
          Vec3(std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b))));
    }
  points.emplace_back(1.15 * half.x(), 0.001, 0.002);
  points.emplace_back(-1.15 * half.x(), 0.001, 0.002);
  return points;
}

TEST(SmoothSolid, IsClosedAndFacesOutwards) {
  for (const Vec3& half : {Vec3(0.08, 0.10, 0.13), Vec3(0.13, 0.08, 0.03)}) {
    const geometry::TriangleMesh egg = smooth_solid(horned(half), {}, 20);
    std::map<std::pair<int, int>, int> directed;
    for (const Triangle& t : egg.triangles)
      for (int k = 0; k < 3; ++k) ++directed[{t[k], t[(k + 1) % 3]}];
    for (const auto& [edge, count] : directed) {
      EXPECT_EQ(count, 1);
      EXPECT_EQ(directed.count({edge.second, edge.first}), 1u);
    }
    EXPECT_NEAR(geometry::enclosed_volume(egg) / (4 * kPi / 3 * half.prod()), 1, 0.12);
  }
}

TEST(SmoothSolid, HasNoHorns) {
  const Vec3 half(0.08, 0.10, 0.13);
  const auto reach = [&](int rounds) {
    double x = 0;
    for (const Vec3& p : smooth_solid(horned(half), {}, rounds).vertices) x = std::max(x, p.x());
    return x;
  };
  EXPECT_GT(reach(0), 1.13 * half.x());
  EXPECT_LT(reach(60), 1.06 * half.x());
}

TEST(SmoothSolid, KeepsWithinCloth) {
  // A sheet before it, 7 cm from the middle.
  geometry::TriangleMesh cloth;
  cloth.vertices = {{-1, -0.07, -1}, {1, -0.07, -1}, {1, -0.07, 1}, {-1, -0.07, 1}};
  cloth.triangles = {{0, 1, 2}, {0, 2, 3}};
  double front = 0, back = 0;
  for (const Vec3& p : smooth_solid(horned({0.08, 0.10, 0.13}), cloth, 20).vertices) {
    front = std::min(front, p.y());
    back = std::max(back, p.y());
  }
  EXPECT_GT(front, -0.0680);
  EXPECT_GT(back, 0.095);
}

TEST(SmoothSolid, OfPointsInAPlaneIsNothing) {
  EXPECT_TRUE(smooth_solid({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, 3).triangles.empty());
  EXPECT_TRUE(smooth_solid({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.3, 0.4, 0}}, {}, 3)
                  .triangles.empty());
}

}  // namespace
}  // namespace loosefit::render
