#include "loosefit/drape/hem_hang.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "support/tube_garment.h"

namespace loosefit::drape {
namespace {

using loosefit::testing::tube_garment;

constexpr double kWidth = 1.0, kLength = 0.6;
constexpr int kAround = 40, kAlong = 24;

/// Straightness of a tube whose vertices lie at height(angle, way up from the hem).
template <class Height>
double straightness(const Height& height) {
  const garment::Garment tube = tube_garment(kWidth, kLength, kAround, kAlong);
  std::vector<Vec3> x;
  for (const Vec2& uv : tube.vertex_uv) {
    const double angle = 2 * std::numbers::pi * uv.x() / kWidth,
                 r = kWidth / (2 * std::numbers::pi);
    x.emplace_back(r * std::cos(angle), r * std::sin(angle), height(angle, uv.y()));
  }
  std::vector<int> neck, hem;
  for (int v = 0; v < tube.vertex_count; ++v) {
    if (tube.vertex_uv[v].y() == 0) hem.push_back(v);
    if (tube.vertex_uv[v].y() == kLength) neck.push_back(v);
  }
  return hang_straightness(tube, neck, hem, x);
}

TEST(HemHang, AStraightTubeHangsAsFarAsItIsLong) {
  EXPECT_NEAR(straightness([](double, double up) { return up; }), 1, 1e-12);
}

TEST(HemHang, AGatheredTubeHangsAsFarAsItIsHigh) {
  EXPECT_NEAR(straightness([](double, double up) { return 0.7 * up; }), 0.7, 1e-12);
}

// A shirt that lies on the seat is gathered behind and hangs in front.
TEST(HemHang, CountsWhatIsGatheredOverAQuarterOfTheHem) {
  const auto behind = [](double share) {
    return straightness([share](double angle, double up) {
      return angle < share * 2 * std::numbers::pi ? std::max(up, 0.3) : up;
    });
  };
  EXPECT_LT(behind(0.35), 0.6);
  EXPECT_GT(behind(0.1), 0.99);
}

TEST(HemHang, CountsAsStraightWithoutAWayFromNeckToHem) {
  const garment::Garment tube = tube_garment(kWidth, kLength, kAround, kAlong);
  const std::vector<Vec3> x(tube.vertex_count, Vec3::Zero());
  EXPECT_EQ(hang_straightness(tube, {}, {0, 1}, x), 1);
}

}  // namespace
}  // namespace loosefit::drape
