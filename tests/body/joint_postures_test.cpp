#include "loosefit/body/joint_postures.h"

#include <gtest/gtest.h>

#include <regex>

#include "loosefit/base/error.h"
#include "loosefit/body/named_postures.h"
#include "support/body_fixture.h"

namespace loosefit::body {
namespace {

Body in(const std::string& posture) { return body_model().build({}, named_posture(posture)); }

Vec3 between(const Body& body, const std::string& from, const std::string& to) {
  return (body.joints.at(to) - body.joints.at(from)).normalized();
}

double angle(const Vec3& a, const Vec3& b) {
  return degrees(std::atan2(a.cross(b).norm(), a.dot(b)));
}

TEST(JointPostures, TheElbowFlexesByItsAngleAndForward) {
  for (const double flexion : {0.0, 30.0, 90.0, 130.0}) {
    const Body body = in(joint_posture_name({{"elbow-flexion", flexion}}));
    for (const std::string side : {"_L", "_R"}) {
      const Vec3 upper = between(body, "shoulder" + side, "elbow" + side),
                 fore = between(body, "elbow" + side, "wrist" + side);
      EXPECT_NEAR(angle(upper, fore), flexion, 0.02) << side;
      if (flexion == 0) continue;
      EXPECT_LT((fore - upper * upper.dot(fore)).normalized().y(), -0.97) << side;
    }
  }
}

TEST(JointPostures, BendingTheElbowTurnsTheHandWithTheForearm) {
  // Skin of hand and wrist moves as one piece, also past the right angle.
  const Body straight = in("elbow-flexion-0");
  for (const double flexion : {60.0, 89.0, 91.0, 130.0}) {
    const Body bent = in(joint_posture_name({{"elbow-flexion", flexion}}));
    int edges = 0;
    for (const Triangle& t : straight.surface.triangles)
      for (int k = 0; k < 3; ++k) {
        const int a = t[k], b = t[(k + 1) % 3];
        const Vec3& p = straight.surface.vertices[a];
        if ((p - straight.joints.at("wrist_L")).norm() > 0.05) continue;
        const double before = (p - straight.surface.vertices[b]).norm(),
                     after = (bent.surface.vertices[a] - bent.surface.vertices[b]).norm();
        ASSERT_NEAR(after / before, 1, 0.02) << flexion;
        ++edges;
      }
    EXPECT_GT(edges, 50);
  }
}

TEST(JointPostures, TheWayFromStandingIsEvenInTheAngle) {
  const Posture bent = named_posture("elbow-flexion-120");
  for (const double share : {0.25, 0.5, 0.75}) {
    const Body body = body_model().build({}, blend(kStanding, bent, share));
    const double rest = angle(between(in("standing"), "shoulder_L", "elbow_L"),
                              between(in("standing"), "elbow_L", "wrist_L"));
    EXPECT_NEAR(angle(between(body, "shoulder_L", "elbow_L"), between(body, "elbow_L", "wrist_L")),
                rest + share * (120 - rest), 0.5);
  }
}

TEST(JointPostures, ArmsRiseForwardAndAside) {
  const Vec3 forward = between(in("shoulder-flexion-90"), "shoulder_L", "elbow_L"),
             aside = between(in("shoulder-abduction-90"), "shoulder_L", "elbow_L");
  EXPECT_LT(forward.y(), -0.97);
  EXPECT_GT(aside.x(), 0.97);
}

TEST(JointPostures, HipAndKneeTurnByTheirAngle) {
  const Body stands = in("standing"), hip = in("hip-flexion-60"), knee = in("knee-flexion-60");
  const auto thigh = [](const Body& b) { return between(b, "hip_L", "knee_L"); };
  const auto shank = [](const Body& b) { return between(b, "knee_L", "ankle_L"); };
  EXPECT_NEAR(angle(thigh(stands), thigh(hip)), 60, 1);
  EXPECT_LT(thigh(hip).y(), -0.5);
  EXPECT_NEAR(angle(thigh(stands), thigh(knee)), 0, 0.01);
  EXPECT_NEAR(angle(shank(stands), shank(knee)), 60, 1);
  EXPECT_GT(shank(knee).y(), 0.5);
}

TEST(JointPostures, OneLegTurnsAlone) {
  const Body stands = in("standing"),
             steps = in("left-hip-flexion-50+left-knee-flexion-40+right-hip-flexion--10");
  const auto turned = [&](const char* from, const char* to) {
    return angle(between(stands, from, to), between(steps, from, to));
  };
  EXPECT_NEAR(turned("hip_L", "knee_L"), 50, 1);
  EXPECT_NEAR(turned("knee_L", "ankle_L"), 10, 1);
  EXPECT_NEAR(turned("hip_R", "knee_R"), 10, 1);
  EXPECT_GT(between(steps, "hip_R", "knee_R").y(), between(stands, "hip_R", "knee_R").y());
  EXPECT_NEAR(turned("knee_R", "ankle_R"), 10, 1);
}

TEST(JointPostures, BothLegsAndOneAddUp) {
  EXPECT_NEAR(angle(between(in("hip-flexion-60"), "hip_L", "knee_L"),
                    between(in("hip-flexion-40+left-hip-flexion-20"), "hip_L", "knee_L")),
              0, 0.01);
  EXPECT_THROW(in("hip-flexion-90+left-hip-flexion-60"), InvalidInput);
}

TEST(JointPostures, TheTrunkTurnsAndBendsToTheLeft) {
  const Body turned = in("trunk-rotation-30"), bent = in("side-bend-20");
  const Vec3 shoulders = between(turned, "shoulder_R", "shoulder_L"),
             hips = between(turned, "hip_R", "hip_L");
  EXPECT_NEAR(degrees(std::atan2(shoulders.y(), shoulders.x())), 30, 1);
  EXPECT_NEAR(degrees(std::atan2(hips.y(), hips.x())), 0, 0.01);
  const Vec3 tilted = between(bent, "shoulder_R", "shoulder_L");
  EXPECT_NEAR(degrees(std::atan2(-tilted.z(), tilted.x())), 20, 1);
}

/// Where the skin next to the left middle knuckles goes.
Vec3 knuckles(const Body& body) {
  const RestBody rest = body_model().rest({});
  const BodyData& data = body_model().data();
  const Vec3& joint =
      rest.joints[std::size_t(data.bones[std::size_t(data.bone("finger3-1.L"))].head)];
  std::size_t nearest = 0;
  for (std::size_t v = 0; v < rest.surface.vertices.size(); ++v)
    if ((rest.surface.vertices[v] - joint).norm() < (rest.surface.vertices[nearest] - joint).norm())
      nearest = v;
  return body.surface.vertices[nearest];
}

TEST(JointPostures, TheHandTurnsToThePalm) {
  // Away from the thigh, which would push the arm aside.
  const Body straight = in("shoulder-abduction-40"),
             flexed = in("shoulder-abduction-40+wrist-flexion-60"),
             extended = in("shoulder-abduction-40+wrist-flexion--60");
  const Vec3 fore = between(straight, "elbow_L", "wrist_L"),
             palm = Vec3::UnitY().cross(fore).normalized();  // faces the thigh
  EXPECT_LT(palm.x(), -0.5);
  EXPECT_GT((knuckles(flexed) - knuckles(straight)).dot(palm), 0.04);
  EXPECT_LT((knuckles(extended) - knuckles(straight)).dot(palm), -0.04);
  EXPECT_LT((straight.joints.at("wrist_L") - flexed.joints.at("wrist_L")).norm(), 1e-3);
}

TEST(JointPostures, BothSidesAreAlike) {
  for (const char* name : {"elbow-flexion-100", "wrist-flexion-40", "hip-flexion-50",
                           "knee-flexion-70", "shoulder-abduction-60", "shoulder-flexion-120"}) {
    const Body body = in(name);
    for (const std::string joint : {"shoulder", "elbow", "wrist", "knee", "ankle"}) {
      const Vec3 l = body.joints.at(joint + "_L"), r = body.joints.at(joint + "_R");
      EXPECT_LT((Vec3(-r.x(), r.y(), r.z()) - l).norm(), 1e-9) << name << " " << joint;
    }
  }
}

TEST(JointPostures, ASitterMovesArmsAndKeepsTheLegs) {
  const Body sitter = in("sitting");
  for (const double flexion : {20.0, 60.0, 90.0, 120.0}) {
    const Body moved =
        in("sitting+" + joint_posture_name({{"elbow-flexion", flexion}, {"shoulder-flexion", 30}}));
    for (const std::string side : {"_L", "_R"}) {
      EXPECT_NEAR(angle(between(moved, "shoulder" + side, "elbow" + side),
                        between(moved, "elbow" + side, "wrist" + side)),
                  flexion, 0.5);
      EXPECT_LT((moved.joints.at("knee" + side) - sitter.joints.at("knee" + side)).norm(), 1e-9);
      EXPECT_GT((moved.joints.at("wrist" + side) - sitter.joints.at("wrist" + side)).norm(), 0.01);
    }
  }
}

TEST(JointPostures, ANamedPostureTakesOnlyJointsThatItLeavesFree) {
  for (const char* wrong : {"sitting+hip-flexion-20", "sitting+left-knee-flexion-20", "sitting+",
                            "sitting+standing", "sitting+elbow-flexion-200", "sit+elbow-flexion-20",
                            "sitting+elbow-flexion-20+elbow-flexion-30"})
    EXPECT_THROW(named_posture(wrong), InvalidInput) << wrong;
  for (const auto& [name, posture] : named_postures())
    EXPECT_NO_THROW(named_posture(name + "+trunk-rotation-20")) << name;
}

TEST(JointPostures, NamesAreReadBack) {
  const std::vector<JointAngle> both = {{"elbow-flexion", 90}, {"wrist-flexion", -12.5}};
  EXPECT_EQ(joint_posture_name(both), "elbow-flexion-90+wrist-flexion--12.5");
  EXPECT_EQ(joint_angles(joint_posture_name(both)), both);
  EXPECT_EQ(joint_angles("standing"), std::nullopt);
  const std::regex pattern("^" + joint_posture_pattern() + "$");
  EXPECT_TRUE(std::regex_match(joint_posture_name(both), pattern));
  EXPECT_FALSE(std::regex_match("elbow-flexion-", pattern));
  for (const char* wrong :
       {"elbow-flexion-", "elbow-flexion-131", "elbow-flexion-9x", "elbow-flexion-nan",
        "elbow-flexion-20+elbow-flexion-30", "elbow-flexion-20+", "elbow-flexion-20+standing"})
    EXPECT_THROW(named_posture(wrong), InvalidInput) << wrong;
}

}  // namespace
}  // namespace loosefit::body
