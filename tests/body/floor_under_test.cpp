#include "loosefit/body/floor_under.h"

#include <gtest/gtest.h>

#include "support/body_fixture.h"
#include "support/stick_person.h"

namespace loosefit::body {
namespace {

Body stick(const Eigen::Isometry3d& motion = Eigen::Isometry3d::Identity()) {
  support::StickPerson person;
  person.body.joints["neck"] = Vec3(0, 0, 1.4);
  return person.moved(motion);
}

TEST(FloorUnder, SolesOfWhoeverStandsWhereverTheyStand) {
  for (const double z : {0.0, 0.4, -1.2}) {
    const auto floor = floor_under(stick(Eigen::Isometry3d(Eigen::Translation3d(1, -2, z))));
    ASSERT_TRUE(floor);
    EXPECT_DOUBLE_EQ(*floor, z);
  }
}

TEST(FloorUnder, NoneWhereFeetAreNotLowestOrNobodyTells) {
  // Head down, and on the back.
  for (const double angle : {180.0, 90.0})
    EXPECT_FALSE(
        floor_under(stick(Eigen::Isometry3d(Eigen::AngleAxisd(radians(angle), Vec3::UnitX())))));
  Body bare = stick();
  bare.segment.clear();
  EXPECT_FALSE(floor_under(bare));
  Body without_joints = stick();
  without_joints.joints.clear();
  EXPECT_FALSE(floor_under(without_joints));
}

TEST(FloorUnder, APersonWhoSitsBendsOrStandsHasTheFeetOnIt) {
  Posture sitting = kStanding, bent = kStanding, one_leg = kStanding;
  sitting.sitting = 1, bent.forward_bend = radians(60.0), one_leg.left_hip_flexion = radians(50.0);
  for (const Posture& posture : {kStanding, kArmsApart, sitting, bent, one_leg}) {
    const auto floor = floor_under(body_model().build(BodyParameters{}, posture));
    ASSERT_TRUE(floor);
    EXPECT_NEAR(*floor, 0, 1e-9);
  }
}

}  // namespace
}  // namespace loosefit::body
