#include "loosefit/validate/trunk_hem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "loosefit/base/error.h"

namespace loosefit::validate {
namespace {

constexpr int kAround = 80;

/// A tube of `radius` with two rings, the lower one at `z` + `slope` y, the upper one 0.4 m higher.
garment::Garment tube(double radius, double z, double slope, std::vector<Vec3>& x) {
  garment::Garment mesh;
  const int first = static_cast<int>(x.size());
  for (int ring = 0; ring < 2; ++ring)
    for (int i = 0; i < kAround; ++i) {
      const double angle = 2 * std::numbers::pi * i / kAround;
      const double y = radius * std::sin(angle);
      x.emplace_back(radius * std::cos(angle), y, z + slope * y + 0.4 * ring);
    }
  for (int i = 0; i < kAround; ++i) {
    const int j = (i + 1) % kAround;
    mesh.triangles.push_back({first + i, first + j, first + kAround + j});
    mesh.triangles.push_back({first + i, first + kAround + j, first + kAround + i});
  }
  return mesh;
}

std::vector<double> heights(const std::vector<Vec3>& x) {
  std::vector<double> z;
  for (const Vec3& p : x) z.push_back(p.z());
  return z;
}

TEST(TrunkHem, IsTheLowerEndOfTheTrunkAndNotACuffBelowIt) {
  std::vector<Vec3> x;
  garment::Garment mesh = tube(0.16, 0.9, 0, x);
  const garment::Garment cuff = tube(0.04, 0.7, 0, x);
  mesh.triangles.insert(mesh.triangles.end(), cuff.triangles.begin(), cuff.triangles.end());
  const std::vector<int> hem = trunk_hem(mesh, x);
  ASSERT_EQ(hem.size(), kAround);
  for (int v : hem) EXPECT_DOUBLE_EQ(x[v].z(), 0.9);
  EXPECT_TRUE(trunk_hem(cuff, x).empty());
}

TEST(TrunkHem, WithoutOneThereAreNoHeights) {
  EXPECT_THROW(hem_means({}, {}, {}), SolverFailure);
}

TEST(TrunkHem, OfATiltedTubeIsHighBehindAndAtItsMiddleAtTheSides) {
  std::vector<Vec3> x;
  const garment::Garment mesh = tube(0.16, 0.9, 0.2, x);
  const HemHeights at = hem_means(trunk_hem(mesh, x), x, heights(x));

  const double rise = 0.2 * 0.16;
  EXPECT_NEAR(at[hem_left], 0.9, 1e-12);
  EXPECT_NEAR(at[hem_right], 0.9, 1e-12);
  EXPECT_GT(at[hem_back], 0.9 + rise * std::cos(radians(25.0)));
  EXPECT_LT(at[hem_back], 0.9 + rise);
  EXPECT_NEAR(at[hem_front] + at[hem_back], 1.8, 1e-12);
}

}  // namespace
}  // namespace loosefit::validate
