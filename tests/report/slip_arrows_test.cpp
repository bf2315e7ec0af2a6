#include "loosefit/report/slip_arrows.h"

#include <gtest/gtest.h>

#include "support/tube_garment.h"

namespace loosefit::report {
namespace {

TEST(SlipArrows, PointFromWhereTheSkinHasGoneToWhereTheClothIs) {
  const body::PosedBody body = testing::cylinder_body(0.12, 1.0, 100, 20);
  const garment::Garment tube = testing::tube_garment(2 * kPi * 0.13, 0.4, 100, 40);
  const auto worn_at = [&](double up) {
    return testing::settled_drape(tube, [up](const Vec2& uv) {
      const double a = uv.x() / 0.13;
      return Vec3(0.13 * std::cos(a), 0.13 * std::sin(a), 0.35 + up + uv.y());
    });
  };
  const drape::Drape before = worn_at(0), after = worn_at(0.008), still = worn_at(0.0005);
  const maps::WornGarment first = maps::relate(tube, before.positions, body);
  const maps::DressedState reference{before.positions, body, first};

  const SlipArrows arrows = slip_arrows(tube, reference, {after.positions, body, first}, 0.05);
  ASSERT_GT(arrows.to.size(), 50u);
  for (std::size_t i = 0; i < arrows.to.size(); ++i) {
    const Vec3 slip = arrows.to[i] - arrows.from[i];
    EXPECT_NEAR(slip.z(), 0.008, 1e-6);
    EXPECT_NEAR(slip.head<2>().norm(), 0, 1e-6);
  }
  EXPECT_TRUE(slip_arrows(tube, reference, {still.positions, body, first}).to.empty())
      << "slips below the least get no arrow";
  const SlipArrows dense = slip_arrows(tube, reference, {after.positions, body, first}, 0.025);
  EXPECT_GT(dense.to.size(), 2 * arrows.to.size());
}

}  // namespace
}  // namespace loosefit::report
