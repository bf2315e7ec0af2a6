#include "loosefit/pipeline/fit_along.h"

#include "loosefit/kinds/girths_along.h"

#include <gtest/gtest.h>

#include "support/body_fixture.h"

namespace loosefit::pipeline {
namespace {

body::Body woman() {
  body::BodyParameters parameters;
  return body_model().build(parameters, body::kArmsApart);
}

TEST(FitAlong, BodyHasItsMeasuresAtTheirStations) {
  const body::Body body = woman();
  const auto& m = body.measured;
  const auto at = [&](const char* limb, double along) {
    const std::vector<StationFit> fits = fit_along({{limb, along, 1.0, 0.5}}, body, kinds::girths_along(body));
    return fits.size() == 1 ? fits[0] : StationFit{};
  };
  const StationFit waist = at("trunk", m.at("hps_to_waist")), hip = at("trunk", m.at("hps_to_hip"));
  EXPECT_NEAR(waist.body, m.at("waist"), 0.01 * m.at("waist"));
  EXPECT_EQ(waist.place, "waist");
  EXPECT_NEAR(hip.body, m.at("hip"), 0.01 * m.at("hip"));
  EXPECT_EQ(hip.place, "hip");
  const double elbow = m.at("elbow_length"), wrist = m.at("arm_length");
  EXPECT_NEAR(at("arm", elbow).body, m.at("elbow"), 0.04 * m.at("elbow"));
  EXPECT_EQ(at("arm", elbow).place, "elbow");
  const StationFit forearm = at("arm", elbow + 0.25 * (wrist - elbow));
  EXPECT_NEAR(forearm.body, m.at("forearm"), 0.04 * m.at("forearm"));
  EXPECT_EQ(forearm.place, "forearm");
  EXPECT_NEAR(forearm.cut(), 1 / forearm.body - 1, 1e-12);
  EXPECT_EQ(forearm.asked, 0.5);
}

// A swollen forearm, left or right: the sleeve is as tight for both, and tighter than for none.
TEST(FitAlong, AnArmThatIsThickerThanTheOtherCountsOnEitherSide) {
  const body::Body body = woman();
  const double elbow = body.measured.at("elbow_length"), wrist = body.measured.at("arm_length");
  const double along = elbow + 0.4 * (wrist - elbow);
  const auto girth = [&](const body::Body& of) {
    const std::vector<StationFit> fits = fit_along({{"arm", along, 1.0, {}}}, of, kinds::girths_along(of));
    return fits.size() == 1 ? fits[0].body : 0;
  };
  for (const char* side : {"_L", "_R"}) {
    body::Body swollen = body;
    const Vec3 from = body.joints.at(std::string("elbow") + side),
               axis = (body.joints.at(std::string("wrist") + side) - from).normalized();
    const int sign = side == std::string("_L") ? 1 : -1;
    for (std::size_t v = 0; v < swollen.segment.size(); ++v) {
      if (swollen.segment[v] != body::Segment::forearm || swollen.side[v] != sign) continue;
      Vec3& p = swollen.surface.vertices[v];
      const Vec3 foot = from + (p - from).dot(axis) * axis;
      p = foot + 1.2 * (p - foot);
    }
    EXPECT_NEAR(girth(swollen), 1.2 * girth(body), 0.02 * girth(body)) << side;
  }
}

// Where the trunk has ended there is no body, which is no error.
TEST(FitAlong, BelowTheCrotchThereIsNoTrunk) {
  body::Body body = woman();
  body.joints["hip_L"].z() -= 0.3;  // how far down a tape is laid
  EXPECT_TRUE(fit_along({{"trunk", 1.0, 1.0, {}}}, body, kinds::girths_along(body)).empty());
}

TEST(FitAlong, SectionsThatGoRoundTheTrunkTooAreLeftOut) {
  const body::Body body = woman();
  EXPECT_TRUE(fit_along({{"arm", 0.0, 1.0, {}}}, body, kinds::girths_along(body)).empty());
}

TEST(FitAlong, SectionsThatGoRoundTheArmsTooAreLeftOut) {
  const body::Body body = woman();
  EXPECT_TRUE(fit_along({{"trunk", 0.16, 1.0, {}}}, body, kinds::girths_along(body)).empty()) << "through the shoulders";
  EXPECT_EQ(fit_along({{"trunk", 0.30, 1.0, {}}}, body, kinds::girths_along(body)).size(), 1u) << "at the chest";
}

TEST(FitAlong, LimbsThatABodyHasNotAreLeftOut) {
  body::Body body = woman();
  body.joints.erase("wrist_L");
  EXPECT_EQ(fit_along({{"arm", 0.3, 1.0, {}}}, body, kinds::girths_along(body)).size(), 1u) << "the right arm";
  body.joints.erase("wrist_R");
  body.landmarks.erase("hps_L");
  EXPECT_TRUE(fit_along({{"arm", 0.3, 1.0, {}}, {"trunk", 0.4, 1.0, {}}}, body, kinds::girths_along(body)).empty());
}

}  // namespace
}  // namespace loosefit::pipeline
