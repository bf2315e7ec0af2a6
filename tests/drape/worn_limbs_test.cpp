#include "loosefit/drape/worn_limbs.h"

#include <gtest/gtest.h>

#include "support/tube_garment.h"

namespace loosefit {
namespace {

/// Arms along x, 0.6 m to either side of an upright trunk.
Body stick_figure() {
  Body body;
  body.joints = {{"neck", {0, 0, 1.4}}, {"hip_L", {0.1, 0, 0.9}}, {"hip_R", {-0.1, 0, 0.9}}};
  for (const auto& [side, sign] : {std::pair(std::string("_L"), 1.0), {std::string("_R"), -1.0}}) {
    body.joints["shoulder" + side] = Vec3(0.2 * sign, 0, 1.35);
    body.joints["elbow" + side] = Vec3(0.4 * sign, 0, 1.35);
    body.joints["wrist" + side] = Vec3(0.6 * sign, 0, 1.35);
  }
  return body;
}

/// A sleeve of 10 cm on the left arm, moved by `shift`.
std::vector<int> sleeve(const Vec3& shift) {
  const Garment tube = testing::tube_garment(0.3, 0.1, 12, 4);
  std::vector<Vec3> x;
  for (const Vec2& p : tube.vertex_uv) {
    const double a = 2 * kPi * p.x() / 0.3;
    x.push_back(Vec3(0.45 + p.y(), 0.05 * std::cos(a), 1.35 + 0.05 * std::sin(a)) + shift);
  }
  return limbs_through_openings(tube.triangles, x, stick_figure());
}

TEST(WornLimbs, TellWhichLimbGoesThroughWhichOpening) {
  const std::vector<int> on = sleeve(Vec3::Zero());
  ASSERT_EQ(on.size(), 6u) << "two openings, three limbs";
  EXPECT_EQ(on[0], 0);
  EXPECT_EQ(std::abs(on[1]), 1);
  EXPECT_EQ(on[2], 0);
  EXPECT_EQ(on[1], -on[4]) << "in at one, out at the other";
}

TEST(WornLimbs, DoNotChangeWhileTheSleeveSlidesAlongTheArm) {
  EXPECT_EQ(sleeve(Vec3(-0.1, 0, 0.02)), sleeve(Vec3::Zero()));
}

TEST(WornLimbs, ChangeWhenTheArmHasLeftTheSleeve) {
  EXPECT_EQ(sleeve(Vec3(0, 0, -0.2)), std::vector<int>(6, 0)) << "hangs empty below";
  EXPECT_EQ(sleeve(Vec3(0.5, 0, 0)), std::vector<int>(6, 0)) << "slid off the hand";
}

/// A collar round the neck, 2 cm high, from height z.
std::vector<int> collar(double z) {
  const Garment tube = testing::tube_garment(0.4, 0.02, 12, 1);
  std::vector<Vec3> x;
  for (const Vec2& p : tube.vertex_uv) {
    const double a = 2 * kPi * p.x() / 0.4;
    x.emplace_back(0.064 * std::cos(a), 0.064 * std::sin(a), z + p.y());
  }
  return limbs_through_openings(tube.triangles, x, stick_figure());
}

TEST(WornLimbs, DoNotChangeWhenANecklineSlipsPastTheJointOfTheNeck) {
  const std::vector<int> low = collar(1.37);
  EXPECT_EQ(low, collar(1.41));
  EXPECT_EQ(std::abs(low[0]), 1) << "the trunk goes through it";
  EXPECT_EQ(low[1], 0) << "the arms do not";
}

TEST(WornLimbs, AreNotKnownWithoutJoints) {
  EXPECT_TRUE(limbs_through_openings({}, {}, Body{}).empty());
}

}  // namespace
}  // namespace loosefit
