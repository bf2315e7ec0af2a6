#include "loosefit/flesh/soft_body.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/body/named_postures.h"
#include "loosefit/geometry/exact_intersection.h"
#include "support/body_fixture.h"

namespace loosefit {
namespace {

BodyParameters woman() {
  BodyParameters parameters;
  parameters.sex = 0;
  return parameters;
}

/// Pairs of triangles of trunk, arms and thighs that cut each other.
int overlaps(const Body& body) {
  const auto dressed = [&](int t) {
    const Segment s = body.segment[body.surface.triangles[t][0]];
    return s == Segment::torso || s == Segment::upper_arm || s == Segment::forearm ||
           s == Segment::thigh;
  };
  int count = 0;
  for (const auto& [s, t] : self_intersections(body.surface.vertices, body.surface.triangles))
    count += dressed(s) && dressed(t);
  return count;
}

void expect_maps_tell_the_surface(const Body& body, const Body& rest) {
  for (std::size_t v = 0; v < rest.surface.vertices.size(); ++v)
    ASSERT_LT(
        (body.pose_from_rest[v] * rest.surface.vertices[v].homogeneous() - body.surface.vertices[v])
            .norm(),
        1e-12);
}

TEST(SoftBody, SkinThatDoesNotOverlapIsLeftAsItIs) {
  SoftBody person(body_model(), woman());
  const Body soft = person.in({}), stiff = body_model().build(woman(), {});
  EXPECT_EQ(soft.surface.vertices, stiff.surface.vertices);
}

TEST(SoftBody, ArmsThatHangCloseLeaveRoomForAShirt) {
  const Posture hanging{radians(8), 0, 0};
  ASSERT_GT(overlaps(body_model().build(woman(), hanging)), 0);
  SoftBody person(body_model(), woman());
  const Body body = person.in(hanging);
  EXPECT_EQ(overlaps(body), 0);
  expect_maps_tell_the_surface(body,
                               body_model().build(woman(), body_model().rest_posture(woman())));
  for (const auto& [name, v] : body.landmark_vertex)
    EXPECT_EQ(body.landmarks.at(name), body.surface.vertices[v]) << name;
}

TEST(SoftBody, SittingFoldsTheGroinWithoutPassingThroughIt) {
  const Posture sitting = named_posture("sitting");
  ASSERT_GT(overlaps(body_model().build(woman(), sitting)), 0);
  SoftBody person(body_model(), woman());
  EXPECT_EQ(overlaps(person.in(sitting)), 0);
  // Asked again, the same bits; a posture between is reached from there.
  EXPECT_EQ(person.in(sitting).surface.vertices, person.in(sitting).surface.vertices);
  EXPECT_EQ(overlaps(person.in(blend(Posture{}, sitting, 0.9))), 0);
}

TEST(SoftBody, ArmsOverheadFoldTheShouldersWithoutPassingThroughThem) {
  SoftBody person(body_model(), woman());
  EXPECT_EQ(overlaps(person.in(named_posture("arms-overhead"))), 0);
}

TEST(SoftBody, PosturesOutOfRangeAreRefused) {
  SoftBody person(body_model(), woman());
  EXPECT_THROW(person.in({radians(200), 0, 0}), InvalidInput);
}

}  // namespace
}  // namespace loosefit
