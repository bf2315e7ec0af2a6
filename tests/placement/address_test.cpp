#include "loosefit/placement/address.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "support/stick_person.h"

namespace loosefit::placement {
namespace {

using Stick = support::StickPerson;

geometry::ClosestPoint skin_at(const body::Body& body, const Vec3& p) {
  return geometry::ClosestPointTree(body.surface).query(p);
}

void expect_address(const BodyAddresses& addresses, const Vec3& place, BodySegment segment,
                    int side, const Vec3& percent, double tolerance = 1e-6) {
  const geometry::ClosestPoint skin = skin_at(addresses.body(), place);
  ASSERT_LT(skin.distance, 1e-9) << "not on the skin: " << place.transpose();
  const auto found = addresses.address(skin);
  ASSERT_TRUE(found);
  EXPECT_EQ(name(found->segment), name(segment));
  EXPECT_EQ(found->side, side);
  EXPECT_LT((found->percent - percent).cwiseAbs().maxCoeff(), tolerance) << found->str();
}

TEST(Address, RatiosRunBetweenTheLandmarks) {
  const Stick stick;
  const BodyAddresses addresses(stick.body);
  using enum BodySegment;
  const double xiphoid = Stick::kSternum - 0.3 * (Stick::kSternum - Stick::kWaist);
  const double z = Stick::kC7 - 0.4 * (Stick::kC7 - xiphoid);
  expect_address(addresses, {0, -Stick::kTrunkY, z}, chest, 0, {50, 100, 40});
  expect_address(addresses, {0, Stick::kTrunkY, z}, chest, 0, {50, 0, 40});
  // The wearer's left flank, 0.16 m of 0.25 m from the middle to the acromion.
  expect_address(addresses, {Stick::kTrunkX, 0, z}, chest, 0, {50 - 50 * 0.16 / 0.25, 50, 40});

  // Under the xiphoid; Y runs from the ASIS, which lie beside the middle, to the back.
  const double belly = Stick::kWaist + 0.7 * (xiphoid - Stick::kWaist);
  const double aside = 0.75 * Stick::kTrunkX;
  const double asis = -Stick::kTrunkY * std::sqrt(1 - 0.75 * 0.75);
  const double kChord = 0.02;  // the ASIS lie on the chords of a polygon
  const double front = 100 * (Stick::kTrunkY + asis) / (asis - Stick::kTrunkY);
  expect_address(addresses, {0, -Stick::kTrunkY, belly}, abdomen, 0, {50, front, 70}, kChord);
  expect_address(addresses, {-Stick::kTrunkX, 0, belly}, abdomen, 0,
                 {50 + 50 * Stick::kTrunkX / aside, 100 * -asis / (Stick::kTrunkY - asis), 70},
                 kChord);

  // Limbs as wide as their joints: the skin is at 0 or 100. Lateral is 100 right and 0 left.
  const double upper = Stick::kElbow + 0.6 * (Stick::kAcromion - Stick::kElbow);
  expect_address(addresses, {-Stick::kArmX - Stick::kArm, 0, upper}, upper_arm, -1, {100, 50, 60});
  expect_address(addresses, {Stick::kArmX + Stick::kArm, 0, upper}, upper_arm, 1, {0, 50, 60});
  expect_address(addresses, {Stick::kArmX, -Stick::kArm, upper}, upper_arm, 1, {50, 100, 60});
  expect_address(addresses, {Stick::kArmX, Stick::kArm, 0.95}, forearm, 1, {50, 0, 40});
  expect_address(addresses, {-Stick::kLegX - Stick::kLeg, 0, 0.65}, thigh, -1, {100, 50, 50});
  expect_address(addresses, {Stick::kLegX, -Stick::kLeg, 0.25}, lower_leg, 1, {50, 100, 50});
}

TEST(Address, EverySkinPointIsFoundBackFromItsRatios) {
  const Stick stick;
  const BodyAddresses addresses(stick.body);
  int tested = 0;
  for (int t = 0; t < static_cast<int>(stick.body.surface.triangles.size()); t += 101) {
    geometry::ClosestPoint skin;
    skin.triangle = t;
    skin.barycentric = {0.5, 0.2, 0.3};
    for (int k = 0; k < 3; ++k)
      skin.point +=
          skin.barycentric[k] * stick.body.surface.vertices[stick.body.surface.triangles[t][k]];
    const auto address = addresses.address(skin);
    ASSERT_TRUE(address);
    EXPECT_LT((addresses.skin(*address).point - skin.point).norm(), 1e-9) << address->str();
    ++tested;
  }
  EXPECT_GT(tested, 100);
}

TEST(Address, APointOffTheSkinGoesSquareToTheLongAxis) {
  const Stick stick;
  const BodyAddresses addresses(stick.body);
  // Both inside and outside of the arm, towards its lateral front.
  const double diagonal = Stick::kArm / std::sqrt(2.0);
  for (const double reach : {10.0, 200.0}) {
    const Vec3 p = addresses.skin({BodySegment::upper_arm, -1, {50 + reach, 50 + reach, 40}}).point;
    EXPECT_NEAR(p.x(), -Stick::kArmX - diagonal, 3e-4);
    EXPECT_NEAR(p.y(), -diagonal, 3e-4);
    EXPECT_NEAR(p.z(), Stick::kElbow + 0.4 * (Stick::kAcromion - Stick::kElbow), 1e-9);
  }
  // Through the arm that hangs beside it to the trunk's own skin.
  const Vec3 flank = addresses.skin({BodySegment::chest, 0, {-50, 50, 30}}).point;
  EXPECT_NEAR(flank.x(), Stick::kTrunkX, 1e-6);
}

TEST(Address, StaysWithAWearerWhoLeans) {
  const Stick stick;
  Eigen::Isometry3d lean = Eigen::Isometry3d::Identity();
  lean.linear() = (Eigen::AngleAxisd(0.6, Vec3::UnitX()) * Eigen::AngleAxisd(0.3, Vec3::UnitZ()))
                      .toRotationMatrix();
  lean.translation() = Vec3(0.3, -0.2, 0.1);
  const body::Body leaning = stick.moved(lean);
  const BodyAddresses upright(stick.body), leant(leaning);
  for (const Vec3& p : {Vec3(0, -0.1, 1.3), Vec3(0.25, 0.04, 1.2), Vec3(-0.29, 0, 0.95)}) {
    const auto a = upright.address(skin_at(stick.body, p));
    const auto b = leant.address(skin_at(leaning, lean * p));
    ASSERT_TRUE(a && b);
    EXPECT_LT((a->percent - b->percent).cwiseAbs().maxCoeff(), 1e-6) << a->str() << b->str();
  }
}

TEST(Address, HingesOfBentAndStraightArms) {
  body::Body body;
  body.joints = {{"shoulder_L", {0.2, 0, 1.4}}, {"elbow_L", {0.2, 0, 1.1}}};
  const auto with_wrist = [&](const Vec3& wrist) {
    body.joints["wrist_L"] = wrist;
    return *arm_of(body, 1);
  };
  // Hanging, bent by 90° to the front: hinge to the wearer's right, fossa up and front.
  const BentLimb bent = with_wrist({0.2, -0.25, 1.1});
  EXPECT_LT((bent.across - Vec3(-1, 0, 0)).norm(), 1e-12);
  EXPECT_LT((bent.front - Vec3(0, -1, 1).normalized()).norm(), 1e-12);
  const BentLimb straight = with_wrist({0.2, 0, 0.85});
  EXPECT_LT((straight.across - Vec3(-1, 0, 0)).norm(), 1e-12);
  EXPECT_LT((straight.front - Vec3(0, -1, 0)).norm(), 1e-12);
  // Held out to the side, straight: the hinge has turned with the arm, the fossa still looks front.
  body.joints["elbow_L"] = Vec3(0.5, 0, 1.4);
  const BentLimb aside = with_wrist({0.75, 0, 1.4});
  EXPECT_LT((aside.across - Vec3(0, 0, -1)).norm(), 1e-12);
  EXPECT_LT((aside.front - Vec3(0, -1, 0)).norm(), 1e-12);
  EXPECT_FALSE(arm_of(body, -1));
}

TEST(Address, BadRatiosNameTheNearestPlace) {
  const Stick stick;
  const BodyAddresses addresses(stick.body);
  const auto complaint = [&](const BodyAddress& address) {
    try {
      addresses.skin(address);
    } catch (const InvalidInput& error) {
      return error.place().key + " | " + error.what() + " | " + error.hint();
    }
    return std::string("accepted");
  };
  using enum BodySegment;
  EXPECT_NE(
      complaint({upper_arm, 0, {0, 50, 50}}).find("side | side: found nothing, expected left"),
      std::string::npos)
      << complaint({upper_arm, 0, {0, 50, 50}});
  EXPECT_NE(complaint({chest, 1, {50, 100, 50}}).find("expected no side"), std::string::npos);
  EXPECT_NE(complaint({thigh, 1, {50.5, 50, 50}}).find("away from the middle"), std::string::npos);
  // The thigh's skin ends at 0.75 m, 75 % of the way from knee to hip.
  const std::string high = complaint({thigh, 1, {0, 50, 90}});
  EXPECT_NE(
      high.find("ratios | ratios: found left thigh [0, 50, 90], expected a place on the thigh"),
      std::string::npos)
      << high;
  EXPECT_NE(high.find("nearest place on it is left thigh [0, 50, 75]"), std::string::npos) << high;

  body::Body armless = stick.body;
  armless.joints.erase("wrist_R");
  EXPECT_THROW(BodyAddresses(armless).skin({forearm, -1, {100, 50, 30}}), InvalidInput);
  EXPECT_FALSE(BodyAddresses(armless).address(skin_at(armless, {-0.29, 0, 0.95})));
}

}  // namespace
}  // namespace loosefit::placement
