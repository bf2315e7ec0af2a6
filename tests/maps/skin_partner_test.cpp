// Slip and orientation errors against the skin partner of a reference state.
#include "loosefit/maps/skin_partner.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/maps/compute_maps.h"
#include "loosefit/maps/orientation_error.h"
#include "support/tube_garment.h"
#include "support/wall_and_patch.h"

namespace loosefit::maps {
namespace {

using testing::turn_about;
constexpr double kArm = 0.05, kCloth = 0.053;  // [m]

/// A sleeve round an upper arm, moved along and round it by these lengths on the cloth.
class SleeveOnArm : public ::testing::Test {
 protected:
  SleeveOnArm() {
    arm_ = testing::cylinder_body(kArm, 0.6, 360, 30);
    arm_.segment.assign(arm_.segment.size(), body::Segment::upper_arm);
    arm_.side.assign(arm_.side.size(), 1);
    arm_.joints["elbow_L"] = Vec3(0, 0, 0.05);
    arm_.joints["shoulder_L"] = Vec3(0, 0, 0.55);
  }
  std::vector<Vec3> sleeve(double along = 0, double around = 0) const {
    std::vector<Vec3> positions;
    for (const Vec2& uv : tube_.vertex_uv) {
      const double a = (uv.x() + around) / kCloth;
      positions.emplace_back(kCloth * std::cos(a), kCloth * std::sin(a), 0.2 + uv.y() + along);
    }
    return positions;
  }
  struct State {
    std::vector<Vec3> positions;
    body::Body body;
    WornGarment worn;
    DressedState view() const { return {positions, body, worn}; }
  };
  State state(const std::vector<Vec3>& positions, const body::Body& body) const {
    return {positions, body, relate(tube_, positions, body)};
  }
  State state(const std::vector<Vec3>& positions) const { return state(positions, arm_); }

  body::Body arm_;
  garment::Garment tube_ = testing::tube_garment(2 * kPi * kCloth, 0.2, 72, 16);
};

TEST_F(SleeveOnArm, SlidingAlongAndAroundIsReadInMillimetres) {
  const State reference = state(sleeve()), now = state(sleeve(0.007, 0.006));
  const auto maps = slip_maps(tube_, reference.view(), now.view());
  ASSERT_EQ(maps.size(), 3u);
  // s = a × n with a upwards: counter-clockwise seen from above, as u runs.
  const double around = 1000 * kCloth * std::sin(0.006 / kCloth);
  for (int v = 0; v < tube_.vertex_count; ++v) {
    EXPECT_NEAR(maps[0].values[v], std::hypot(7, around), 0.03);
    EXPECT_NEAR(maps[1].values[v], 7, 0.01);
    EXPECT_NEAR(maps[2].values[v], around, 0.03);
    EXPECT_NEAR(maps[2].values[v], 6, 0.05);
  }
}

TEST_F(SleeveOnArm, BackwardsIsNegativeAndLiftingOffIsNoSlip) {
  const State reference = state(sleeve());
  const State down = state(sleeve(-0.004, -0.003));
  auto wide = sleeve();
  for (Vec3& p : wide) p.head<2>() *= 1.4;
  const State lifted = state(wide);
  const auto back = slip_maps(tube_, reference.view(), down.view());
  const auto off = slip_maps(tube_, reference.view(), lifted.view());
  for (int v = 0; v < tube_.vertex_count; ++v) {
    EXPECT_NEAR(back[1].values[v], -4, 0.02);
    EXPECT_NEAR(back[2].values[v], -3, 0.03);
    EXPECT_NEAR(off[0].values[v], 0, 0.02);
  }
}

TEST_F(SleeveOnArm, MovingTheArmWithItsSleeveIsNoSlipAndNoError) {
  const State reference = state(sleeve());
  const Mat3 turn = turn_about(Vec3(1, 1, -0.3), 1.9);
  const Vec3 move(0.3, -0.1, 0.4);
  const State now = state(testing::moved(sleeve(), turn, move), testing::moved(arm_, turn, move));
  const std::vector<PerformanceMap> slips = slip_maps(tube_, reference.view(), now.view());
  for (double slip : slips[0].values) EXPECT_NEAR(slip, 0, 1e-9);
  for (const PerformanceMap& map :
       orientation_error_maps(tube_, reference.view(), {now.view(), now.view()}))
    for (double error : map.values) EXPECT_NEAR(error, 0, 1e-6);
}

TEST_F(SleeveOnArm, SlidingWhileTheArmMovesIsTheSlidingAlone) {
  const State reference = state(sleeve());
  const Mat3 turn = turn_about(Vec3(0.2, 1, 0.7), -1.1);
  const State now =
      state(testing::moved(sleeve(0.005), turn, {0, 0, 1}), testing::moved(arm_, turn, {0, 0, 1}));
  const auto maps = slip_maps(tube_, reference.view(), now.view());
  for (int v = 0; v < tube_.vertex_count; ++v) {
    EXPECT_NEAR(maps[1].values[v], 5, 1e-6);
    EXPECT_NEAR(maps[2].values[v], 0, 1e-6);
  }
}

// A sensor that slides round a limb turns with the cloth: by the angle slid, though the cloth lies
// as flat on the skin as before and its closest partner would show nothing.
TEST_F(SleeveOnArm, OrientationErrorOfSlidingRoundIsTheAngleSlid) {
  const State reference = state(sleeve());
  const State ten = state(sleeve(0, radians(10) * kCloth)),
              twenty = state(sleeve(0.01, radians(20) * kCloth));
  const auto maps = orientation_error_maps(tube_, reference.view(), {ten.view(), twenty.view()});
  ASSERT_EQ(maps.size(), 2u);
  EXPECT_EQ(maps[0].array, "coe_rms_deg");
  EXPECT_EQ(maps[1].array, "coe_p95_deg");
  for (int v = 72; v < tube_.vertex_count - 72; ++v) {
    EXPECT_NEAR(maps[0].values[v], std::sqrt((100 + 400) / 2.0), 0.05);
    EXPECT_NEAR(maps[1].values[v], 20, 0.05);
  }
}

TEST_F(SleeveOnArm, SlipDirectionsAreUnknownWithoutJointsButNotItsLength) {
  arm_.joints.clear();
  const State reference = state(sleeve()), now = state(sleeve(0.007, 0));
  const auto maps = slip_maps(tube_, reference.view(), now.view());
  for (int v = 0; v < tube_.vertex_count; ++v) {
    EXPECT_NEAR(maps[0].values[v], 7, 0.03);
    EXPECT_TRUE(std::isnan(maps[1].values[v]));
    EXPECT_TRUE(std::isnan(maps[2].values[v]));
  }
}

TEST_F(SleeveOnArm, OtherBodiesAndGarmentsAreRefused) {
  const State reference = state(sleeve());
  const body::Body thin = testing::cylinder_body(kArm, 0.6, 300, 30);
  const State other = state(sleeve(), thin);
  EXPECT_THROW(slip_maps(tube_, reference.view(), other.view()), InvalidInput);
  EXPECT_THROW(orientation_error_maps(tube_, reference.view(), {other.view()}), InvalidInput);
  EXPECT_THROW(orientation_error_maps(tube_, reference.view(), {}), InvalidInput);
  State cut = reference;
  cut.positions.pop_back();
  EXPECT_THROW(slip_maps(tube_, reference.view(), cut.view()), InvalidInput);
  EXPECT_THROW(slip_maps(tube_, cut.view(), reference.view()), InvalidInput);
  EXPECT_THROW(orientation_error_maps(tube_, reference.view(), {cut.view()}), InvalidInput);
}

TEST(CalibratedError, IsTheAngleBetweenTheTwoWhateverTheTangentOfTheBody) {
  const Mat3 reference = turn_about(Vec3(0.3, 1, -2), 0.8);
  const Mat3 now = turn_about(Vec3(1, -1, 0.5), radians(7)) * reference;
  EXPECT_NEAR(degrees(calibrated_error(now, reference)), 7, 1e-9);
  const Mat3 tangent = turn_about(Vec3::UnitZ(), 2.2);
  EXPECT_NEAR(degrees(calibrated_error(tangent * now, tangent * reference)), 7, 1e-9);
  EXPECT_LT(calibrated_error(reference, reference), 1e-12);
}

TEST(ErrorSummary, IsRmsAndTheLeastErrorThatNineteenOfTwentyStayBelow) {
  const ErrorSummary few = summarise({3, 4});
  EXPECT_DOUBLE_EQ(few.rms, std::sqrt(12.5));
  EXPECT_DOUBLE_EQ(few.p95, 4);
  std::vector<double> twenty;
  for (int i = 20; i >= 1; --i) twenty.push_back(i);
  EXPECT_DOUBLE_EQ(summarise(twenty).p95, 19);
  EXPECT_THROW(summarise({}), InvalidInput);
}

}  // namespace
}  // namespace loosefit::maps
