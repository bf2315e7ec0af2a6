#include "loosefit/flesh/soft_way.h"

#include <gtest/gtest.h>

#include "support/body_fixture.h"

namespace loosefit::flesh {
namespace {

body::BodyParameters woman() {
  body::BodyParameters parameters;
  parameters.sex = 0;
  return parameters;
}

double farthest(const body::Body& a, const body::Body& b) {
  double most = 0;
  for (std::size_t v = 0; v < a.surface.vertices.size(); ++v)
    most = std::max(most, (a.surface.vertices[v] - b.surface.vertices[v]).norm());
  return most;
}

TEST(SoftWay, IsTheVeryPersonAtItsStopsAndNearlyInBetween) {
  const body::Posture from{radians(8), 0, 0}, to{radians(25), 0, 0, radians(20)};
  const auto person = std::make_shared<SoftBody>(body_model(), woman());
  SoftWay way(person, from, to);  // two stops
  EXPECT_EQ(way.at(0)->surface.vertices, person->in(from)->surface.vertices);
  EXPECT_EQ(way.at(1)->surface.vertices, person->in(to)->surface.vertices);
  const body::Posture posture = body::blend(from, to, 0.2);
  const body::PosedBody between = way.at(0.2);
  SoftBody other(body_model(), woman());
  const body::PosedBody soft = other.in(posture);
  const body::Body built = other.as_built(posture);
  EXPECT_GT(farthest(built, soft), 0.003) << "flesh gives way there";
  EXPECT_LT(farthest(between, soft), 0.5 * farthest(built, soft));
  const body::Body rest = body_model().build(woman(), body_model().rest_posture(woman()));
  for (std::size_t v = 0; v < rest.surface.vertices.size(); ++v)
    ASSERT_LT((between->pose_from_rest[v] * rest.surface.vertices[v].homogeneous() -
               between->surface.vertices[v])
                  .norm(),
              1e-12);
}

TEST(SoftWay, LeavesSkinThatNeverOverlapsAsBuilt) {
  const body::Posture from{radians(60), 0, 0}, to{radians(70), 0, 0};
  const auto person = std::make_shared<SoftBody>(body_model(), woman());
  SoftWay way(person, from, to);
  EXPECT_EQ(way.at(0.3)->surface.vertices,
            person->as_built(body::blend(from, to, 0.3)).surface.vertices);
}

}  // namespace
}  // namespace loosefit::flesh
