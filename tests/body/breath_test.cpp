#include "loosefit/body/breath.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "support/body_fixture.h"

namespace loosefit::body {
namespace {

Body standing(double sex = 0) {
  BodyParameters parameters;
  parameters.sex = sex;
  return body_model().build(parameters, kStanding);
}

TEST(Breath, WidensTheChestByTheShareOfItsGirth) {
  for (const double sex : {0.0, 1.0}) {
    const Body before = standing(sex);
    const double girth = breathing_girth(before);
    for (const double growth : {0.01, 0.02, 0.04})
      EXPECT_NEAR(breathing_girth(inhaled(before, growth)) / girth - 1, growth, 1e-4) << sex;
  }
}

TEST(Breath, MovesTheFrontOfTheTrunkForwardAndNothingElse) {
  const Body before = standing(), after = inhaled(before, 0.02);
  double farthest = 0;
  for (std::size_t v = 0; v < before.surface.vertices.size(); ++v) {
    const Vec3 way = after.surface.vertices[v] - before.surface.vertices[v];
    farthest = std::max(farthest, way.norm());
    EXPECT_LT(std::abs(way.x()), 1e-12) << v;
    if (before.segment[v] == Segment::torso || before.segment[v] == Segment::neck) continue;
    EXPECT_LT(way.norm(), 0.003) << v << ": arms, legs and head";
  }
  EXPECT_GT(farthest, 0.004);
  EXPECT_LT(farthest, 0.020);
  EXPECT_LT(after.landmarks.at("sternum").y(), before.landmarks.at("sternum").y() - 0.004);
  EXPECT_EQ(after.joints.at("shoulder_L"), before.joints.at("shoulder_L"));
}

TEST(Breath, MapsStillCarryTheRestBody) {
  const BodyModel& model = body_model();
  const Body rest = model.build({}, model.rest_posture({}));
  const Body after = inhaled(model.build({}, kStanding), 0.02);
  double worst = 0;
  for (std::size_t v = 0; v < rest.surface.vertices.size(); ++v)
    worst = std::max(worst, (after.pose_from_rest[v] * rest.surface.vertices[v].homogeneous() -
                             after.surface.vertices[v])
                                .norm());
  EXPECT_LT(worst, 1e-9);
}

TEST(Breath, NoBreathIsTheSameBody) {
  const Body before = standing();
  EXPECT_EQ(inhaled(before, 0).surface.vertices, before.surface.vertices);
}

TEST(Breath, NeedsATrunk) {
  Body bare = standing();
  bare.joints.erase("neck");
  EXPECT_THROW(inhaled(bare, 0.02), InvalidInput);
}

}  // namespace
}  // namespace loosefit::body
