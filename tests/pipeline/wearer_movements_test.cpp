#include "loosefit/pipeline/wearer_movements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "loosefit/body/breath.h"
#include "loosefit/io/scenario.h"
#include "loosefit/pipeline/case_body.h"
#include "loosefit/pipeline/wear_states.h"

namespace loosefit::pipeline {
namespace {

const CaseBody& wearer() {
  static const CaseBody body = make_body({});
  return body;
}

drape::Movements made_by(const CaseBody& body, const std::vector<CaseMovement>& movements) {
  return movements_of(body.body, body.person, body.to, movements);
}

double degrees_forward(const body::Body& body) {
  const Vec3 arm = body.joints.at("elbow_L") - body.joints.at("shoulder_L");
  return degrees(std::atan2(-arm.y(), -arm.z()));
}

TEST(WearerMovements, FurtherDonningsHaveAHistoryOfTheirOwn) {
  const scenario::Scenario s = io::parse_scenario("[donning]\nrepeats = 40\n", "case.toml");
  const CaseWear wear = plan_wear(s);
  EXPECT_EQ(wear.donnings[0].movements, usual_movements(s.donning));
  std::set<std::string> orders;
  double squares = 0;
  int sizes = 0;
  for (std::size_t k = 1; k < wear.donnings.size(); ++k) {
    std::string order;
    for (const CaseMovement& m : wear.donnings[k].movements) {
      order += m.name + " ";
      squares += std::pow(std::log(m.size), 2), ++sizes;
    }
    orders.insert(order);
  }
  EXPECT_EQ(orders.size(), 6u) << "all orders of three movements, then fidgeting";
  EXPECT_NEAR(std::sqrt(squares / sizes), 0.27, 0.05) << "0.3, cut at two deviations";
  EXPECT_EQ(plan_wear(s).donnings[7].movements, wear.donnings[7].movements);
}

TEST(WearerMovements, WithoutASpreadAllDonningsMoveAlike) {
  scenario::ScenarioDonning donning;
  donning.movement_spread = 0;
  EXPECT_EQ(drawn_movements(donning, 5), usual_movements(donning));
}

TEST(WearerMovements, LeadThereAndEndOnTheVeryBodyThatStandsThere) {
  const CaseBody body = wearer();
  const drape::Movements made = made_by(body, {{"hem-pull", 1}, {"arm-raise", 1}, {"breath", 1}});
  ASSERT_EQ(made.size(), 3u);
  EXPECT_FALSE(made[0].way);
  EXPECT_DOUBLE_EQ(made[0].hem_pull, 5);
  for (std::size_t k : {1u, 2u}) {
    EXPECT_EQ(made[k].hem_pull, k == 1 ? 5 : 0) << "as the arms come down";
    EXPECT_EQ(made[k].way(0)->surface.vertices, body.body->surface.vertices) << made[k].name;
  }
  EXPECT_NEAR(degrees_forward(made[1].way(1)) - degrees_forward(body.body), 45, 3);
  EXPECT_NEAR(body::breathing_girth(made[2].way(1)) / body::breathing_girth(body.body), 1.02, 1e-4);
}

TEST(WearerMovements, SizesScaleThem) {
  const drape::Movements made =
      made_by(wearer(), {{"hem-pull", 2}, {"arm-raise", 0.5}, {"breath", 0.5}});
  EXPECT_DOUBLE_EQ(made[0].hem_pull, 10);
  EXPECT_NEAR(degrees_forward(made[1].way(1)) - degrees_forward(wearer().body), 22.5, 3);
  EXPECT_NEAR(body::breathing_girth(made[2].way(1)) / body::breathing_girth(wearer().body), 1.01,
              1e-4);
}

TEST(WearerMovements, AnArmGoesAsFarAsItsJoint) {
  scenario::ScenarioBody wished;
  wished.posture.arm_flexion = radians(59);
  const drape::Movements made = made_by(make_body(wished), {{"arm-raise", 3}});
  ASSERT_EQ(made.size(), 1u);
  EXPECT_NEAR(std::abs(degrees_forward(made[0].way(1))), 180, 20);
}

TEST(WearerMovements, FidgetingLeavesAFifthOfFrictionToThePowerOfItsSize) {
  const drape::Movements made = made_by(wearer(), {{"fidget", 1}});
  ASSERT_EQ(made.size(), 1u);
  EXPECT_FALSE(made[0].way);
  EXPECT_DOUBLE_EQ(made[0].friction_share, 0.2);
  EXPECT_NEAR(made_by(wearer(), {{"fidget", 2}})[0].friction_share, 0.04, 1e-12);
}

TEST(WearerMovements, RaisedArmsAreLoweredInstead) {
  CaseBody body = wearer();
  body.to.arm_flexion = radians(160);
  const drape::Movements made = made_by(body, {{"arm-raise", 1}});
  EXPECT_GT(made[0].way(0)->joints.at("wrist_L").z(), made[0].way(1)->joints.at("wrist_L").z());
}

TEST(WearerMovements, AScanKeepsItsArmsAndBreathes) {
  CaseBody scan = wearer();
  scan.person = nullptr;
  const drape::Movements made = made_by(scan, {{"arm-raise", 1}, {"breath", 1}});
  ASSERT_EQ(made.size(), 1u);
  EXPECT_EQ(made[0].name, "breath");
}

}  // namespace
}  // namespace loosefit::pipeline
