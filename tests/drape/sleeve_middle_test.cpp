#include "loosefit/drape/sleeve_middle.h"

#include <gtest/gtest.h>

#include <numeric>

namespace loosefit::drape {
namespace {

/// A sleeve along −x from its end at 0: straight on one side, tapering by `taper` on the other,
/// with a cap of 0.1 m beyond 0.4 m, of which only the straight side is there.
std::vector<Vec3> tapering(double breadth, double taper) {
  std::vector<Vec3> x;
  for (int i = 0; i <= 50; ++i) {
    const double s = 0.01 * i;
    const double low =
        s <= 0.4 ? -breadth + taper * (1 - s / 0.4) : -breadth * (1 - (s - 0.4) / 0.1);
    for (int j = 0; j <= 10; ++j) x.emplace_back(-s, low * j / 10.0, 0);
  }
  return x;
}

SleeveMiddle middle_of(const std::vector<Vec3>& x) {
  std::vector<int> all(x.size());
  std::iota(all.begin(), all.end(), 0);
  return {all, x, Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()};
}

TEST(SleeveMiddle, IsHalfWayAcrossASleeveThatTapersToOneSide) {
  const SleeveMiddle middle = middle_of(tapering(0.2, 0.08));
  for (double s = 0.05; s < 0.36; s += 0.02)
    EXPECT_NEAR(middle.at(-s), (-0.2 + 0.08 * (1 - s / 0.4)) / 2, 0.004) << s;
}

TEST(SleeveMiddle, StaysWhereItIsAtTheFootOfTheCap) {
  const SleeveMiddle middle = middle_of(tapering(0.2, 0));
  for (const double s : {0.1, 0.38, 0.42, 0.47, 0.5}) EXPECT_NEAR(middle.at(-s), -0.1, 1e-9) << s;
}

TEST(SleeveMiddle, DoesNotJump) {
  const SleeveMiddle middle = middle_of(tapering(0.2, 0.08));
  for (double s = 0; s < 0.5; s += 0.001)
    EXPECT_LT(std::abs(middle.at(-s - 0.001) - middle.at(-s)), 0.0005) << s;
}

}  // namespace
}  // namespace loosefit::drape
