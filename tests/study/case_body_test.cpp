#include "loosefit/study/case_body.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/study/run_case.h"

namespace loosefit {
namespace {

double arm_angle(const Body& body) {
  const Vec3 arm = body.joints.at("elbow_L") - body.joints.at("shoulder_L");
  return degrees(std::acos(-arm.normalized().z()));
}

Progress& silent() {
  static Progress progress;
  return progress;
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

CaseResult small_shirt_on_a_stout_man(const std::string& body) {
  return run_case(
      parse_scenario("[body]\nsex = 1\nage = 59.4\nheight = 1.682\n" + body +
                         "measurements = { chest = 1.115, waist = 1.089, hip = 1.118 }\n"
                         "[garment]\nsize = \"women-40\"\n"
                         "[simulation]\nedge_length = 0.02\ntime_budget = 0.1\n",
                     "case.toml"),
      silent(), {.only_drape = true});
}

TEST(PutOn, SpreadsTheArmsWhereTheUsualPostureLeavesNoRoom) {
  const CaseResult result = small_shirt_on_a_stout_man("");
  ASSERT_FALSE(result.body.warnings.empty());
  EXPECT_NE(result.body.warnings.back().find("arms wide apart"), std::string::npos);
  EXPECT_NEAR(arm_angle(result.body.path(0)), 55, 2);
}

TEST(PutOn, KeepsToThePostureThatWasAskedFor) {
  EXPECT_THROW(small_shirt_on_a_stout_man("dress_posture = { arm_abduction_deg = 24 }\n"),
               InvalidInput);
}

}  // namespace
}  // namespace loosefit
