#include "loosefit/body/named_postures.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "support/body_fixture.h"

namespace loosefit::body {
namespace {

Body in(const std::string& posture) { return body_model().build({}, named_posture(posture)); }

double turn_of_back(const Body& body) {
  const Vec3 back = body.landmarks.at("c7") - body.landmarks.at("back_waist");
  return degrees(std::atan2(-back.y(), back.z()));
}

Vec3 upper_arm(const Body& body) {
  return (body.joints.at("elbow_L") - body.joints.at("shoulder_L")).normalized();
}

Vec3 forearm(const Body& body) {
  return (body.joints.at("wrist_L") - body.joints.at("elbow_L")).normalized();
}

TEST(NamedPostures, RaisedArmsPointWhereTheyShouldAndAreStraight) {
  const Body forward = in("arms-forward"), overhead = in("arms-overhead");
  EXPECT_LT(upper_arm(forward).y(), -std::cos(radians(12)));
  EXPECT_NEAR(upper_arm(forward).z(), 0, 0.02);
  // 160° forward of arms that are 20° aside: within 28° of straight up, by hand.
  EXPECT_NEAR(upper_arm(overhead).z(), std::cos(radians(20)) * std::cos(radians(20)), 0.01);
  for (const Body* body : {&forward, &overhead})
    EXPECT_GT(upper_arm(*body).dot(forearm(*body)), std::cos(radians(1)));
  EXPECT_LT(upper_arm(in("standing")).dot(forearm(in("standing"))), std::cos(radians(30)));
}

TEST(NamedPostures, BendsLeanTheBackAndLetTheArmsHang) {
  const double upright = turn_of_back(in("standing"));
  for (const double lean : {15.0, 30.0, 45.0}) {
    const Body body = in("forward-bend-" + std::to_string(static_cast<int>(lean)));
    EXPECT_NEAR(turn_of_back(body) - upright, lean, 2) << lean;
    EXPECT_NEAR(upper_arm(body).y(), upper_arm(in("standing")).y(), 0.1) << lean;
  }
}

TEST(NamedPostures, ASlouchRoundsTheBackAndLowersTheHead) {
  const Body upright = in("standing"), slumped = in("slouch");
  EXPECT_GT(turn_of_back(slumped) - turn_of_back(upright), 10);
  EXPECT_LT(slumped.landmarks.at("c7").z(), upright.landmarks.at("c7").z() - 0.02);
}

TEST(NamedPostures, AreMirrorSymmetric) {
  for (const auto& [name, posture] : named_postures()) {
    const Body body = body_model().build({}, posture);
    for (const char* joint : {"shoulder", "elbow", "wrist"}) {
      const Vec3 l = body.joints.at(std::string(joint) + "_L"),
                 r = body.joints.at(std::string(joint) + "_R");
      EXPECT_LT((Vec3(-r.x(), r.y(), r.z()) - l).norm(), 1e-9) << name << " " << joint;
    }
  }
}

TEST(NamedPostures, AnUnknownNameIsToldTheNearest) {
  try {
    named_posture("arms-foward");
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(error.hint().find("arms-forward"), std::string::npos) << error.hint();
  }
  Posture posture;
  posture.slouch = 1.5;
  EXPECT_THROW(body_model().build({}, posture), InvalidInput);
  posture.slouch = 0, posture.arm_flexion = radians(200);
  EXPECT_THROW(body_model().build({}, posture), InvalidInput);
}

TEST(NamedPostures, BlendGoesHalfWayInEveryAngle) {
  const Posture half = blend(named_posture("standing"), named_posture("arms-overhead"), 0.5);
  EXPECT_DOUBLE_EQ(degrees(half.arm_flexion), 80);
  EXPECT_DOUBLE_EQ(degrees(half.arm_abduction), 22.5);
  EXPECT_DOUBLE_EQ(half.elbow_extension, 0.5);
  EXPECT_EQ(default_dress_posture(named_posture("arms-forward")).arm_flexion, 0);
  EXPECT_EQ(default_dress_posture(named_posture("slouch")).slouch, 0);
}

}  // namespace
}  // namespace loosefit::body
