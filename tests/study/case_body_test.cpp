#include "loosefit/study/case_body.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"

namespace loosefit {
namespace {

double arm_angle(const Body& body) {
  const Vec3 arm = body.joints.at("elbow_L") - body.joints.at("shoulder_L");
  return degrees(std::acos(-arm.normalized().z()));
}

TEST(MakeBody, MeetsTheWishesAndListsThem) {
  ScenarioBody wished;
  wished.measurements = {{"chest", 0.90}, {"waist", 0.74}};
  const CaseBody made = make_body(wished);
  EXPECT_NEAR(made.body.measured.at("height"), 1.68, 0.005);
  EXPECT_NEAR(made.body.measured.at("chest"), 0.90, 0.005);
  EXPECT_NEAR(made.body.measured.at("waist"), 0.74, 0.005);
  EXPECT_GE(made.asked.size(), 2u);
}

TEST(MakeBody, PathLeadsFromDressingToWantedPostureOnOneTopology) {
  const CaseBody made = make_body({});
  const Body start = made.path(0), end = made.path(1);
  EXPECT_EQ(start.surface.triangles, end.surface.triangles);
  EXPECT_NEAR(arm_angle(start), 40, 2);
  EXPECT_NEAR(arm_angle(end), 25, 2);
  EXPECT_EQ(end.surface.vertices, made.body.surface.vertices) << "the same bits every time";
}

TEST(MakeBody, MissingScanIsAnError) {
  ScenarioBody wished;
  wished.file = "/nowhere/scan.obj";
  EXPECT_THROW(make_body(wished), Error);
}

}  // namespace
}  // namespace loosefit
