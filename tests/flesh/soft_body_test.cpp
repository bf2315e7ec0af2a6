#include "loosefit/flesh/soft_body.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>

#include "loosefit/base/disk_cache.h"
#include "loosefit/base/error.h"
#include "loosefit/body/body_fit.h"
#include "loosefit/body/named_postures.h"
#include "loosefit/geometry/exact_intersection.h"
#include "support/body_fixture.h"
#include "support/scratch_folder.h"

namespace loosefit::flesh {
namespace {

body::BodyParameters woman() {
  body::BodyParameters parameters;
  parameters.sex = 0;
  return parameters;
}

/// Pairs of triangles of trunk, arms and thighs that cut each other.
int overlaps(const body::Body& body) {
  const auto dressed = [&](int t) {
    const body::Segment s = body.segment[body.surface.triangles[t][0]];
    return s == body::Segment::torso || s == body::Segment::neck || s == body::Segment::upper_arm ||
           s == body::Segment::forearm || s == body::Segment::thigh;
  };
  int count = 0;
  for (const auto& [s, t] :
       geometry::self_intersections(body.surface.vertices, body.surface.triangles))
    count += dressed(s) && dressed(t);
  return count;
}

void expect_maps_tell_the_surface(const body::Body& body, const body::Body& rest) {
  for (std::size_t v = 0; v < rest.surface.vertices.size(); ++v)
    ASSERT_LT(
        (body.pose_from_rest[v] * rest.surface.vertices[v].homogeneous() - body.surface.vertices[v])
            .norm(),
        1e-12);
}

TEST(SoftBody, SkinThatDoesNotOverlapIsLeftAsItIs) {
  SoftBody person(body_model(), woman());
  const body::Body soft = person.in({}), stiff = body_model().build(woman(), {});
  EXPECT_EQ(soft.surface.vertices, stiff.surface.vertices);
}

TEST(SoftBody, ArmsThatHangCloseDoNotPassThroughTheTrunk) {
  const body::Posture hanging{radians(8), 0, 0};
  ASSERT_GT(overlaps(body_model().build(woman(), hanging)), 0);
  SoftBody person(body_model(), woman());
  const body::Body body = person.in(hanging);
  EXPECT_EQ(overlaps(body), 0);
  expect_maps_tell_the_surface(body,
                               body_model().build(woman(), body_model().rest_posture(woman())));
  for (const auto& [name, v] : body.landmark_vertex)
    EXPECT_EQ(body.landmarks.at(name), body.surface.vertices[v]) << name;
}

TEST(SoftBody, SittingFoldsTheGroinWithoutPassingThroughIt) {
  const body::Posture sitting = body::named_posture("sitting");
  ASSERT_GT(overlaps(body_model().build(woman(), sitting)), 0);
  SoftBody person(body_model(), woman());
  const body::Body first = person.in(sitting);
  EXPECT_EQ(overlaps(first), 0);
  EXPECT_EQ(person.in(sitting)->surface.vertices, first.surface.vertices);
}

TEST(SoftBody, MergesTheCacheOfACopyAndStartsWithoutIt) {
  const body::Posture hanging{radians(8), 0, 0}, between{radians(13), 0, 0};
  SoftBody person(body_model(), woman());
  SoftBody copy = person;
  copy.in(hanging);
  const body::Body near = copy.in(between);
  // Led from the rest posture instead of from the arms that hang closer.
  EXPECT_NE(person.without_cache().in(between)->surface.vertices, near.surface.vertices);
  person.merge_cache(copy);
  EXPECT_EQ(person.in(between)->surface.vertices, near.surface.vertices);
}

TEST(SoftBody, PosturesBetweenThoseOfBeforeAreReachedFromThere) {
  const body::Posture from{radians(14), 0, 0}, to{radians(6), 0, 0};
  SoftBody person(body_model(), woman());
  for (double share : {0.0, 1.0, 0.5, 0.25}) {
    const body::Posture between = body::blend(from, to, share);
    ASSERT_GT(overlaps(body_model().build(woman(), between)), 0) << share;
    EXPECT_EQ(overlaps(person.in(between)), 0) << share;
  }
}

TEST(SoftBody, ArmsOverheadFoldTheShouldersWithoutPassingThroughThem) {
  const body::Posture overhead = body::named_posture("arms-overhead");
  ASSERT_GT(overlaps(body_model().build(woman(), overhead)), 0);
  SoftBody person(body_model(), woman());
  EXPECT_EQ(overlaps(person.in(overhead)), 0);
}

TEST(SoftBody, WhatOverlapsAtRestDoesNotKeepTheRestOfTheFleshFromGivingWay) {
  // Creases of old shoulders pass through each other in the rest posture already.
  body::BodySpec spec;
  spec.sex = 0, spec.age = 70, spec.height = 1.60;
  spec.measurements = {{"chest", 1.04}, {"waist", 0.94}, {"hip", 1.08}};
  const body::BodyParameters old = body::fit_body(body_model(), spec).parameters;
  SoftBody person(body_model(), old);
  const body::Body rest = body_model().build(old, body_model().rest_posture(old));
  const auto at_rest = overlaps_of(rest);
  ASSERT_FALSE(at_rest.empty());
  const std::set<std::pair<int, int>> known(at_rest.begin(), at_rest.end());
  const body::Posture hanging{radians(8), 0, 0};
  int built = 0;
  for (const auto& pair : overlaps_of(body_model().build(old, hanging)))
    built += !known.count(pair);
  ASSERT_GT(built, 0);
  // The second is reached from the first.
  for (const body::Posture& posture : {hanging, body::Posture{radians(10), 0, 0}})
    for (const auto& pair : overlaps_of(person.in(posture)))
      EXPECT_TRUE(known.count(pair)) << pair.first << " " << pair.second;
  EXPECT_TRUE(person.left_in(person.in(hanging)).empty());
  EXPECT_EQ(int(SoftBody(body_model(), old).left_in(body_model().build(old, hanging)).size()),
            built);
}

TEST(SoftBody, PosturesOutOfRangeAreRefused) {
  SoftBody person(body_model(), woman());
  EXPECT_THROW(person.in({radians(200), 0, 0}), InvalidInput);
}

TEST(SoftBody, TheDiskCacheChangesNoBit) {
  const support::ScratchFolder folder;
  setenv("LOOSEFIT_CACHE", folder.path().c_str(), 1);
  const std::vector<body::Posture> postures = {
      {radians(8), 0, 0}, {}, {radians(12), radians(10), 0}, body::kStanding};
  const auto surfaces = [&] {
    SoftBody person(body_model(), woman());
    std::vector<std::vector<Vec3>> all;
    for (const body::Posture& posture : postures)
      all.push_back(person.in(posture)->surface.vertices);
    return all;
  };
  const auto without = surfaces();
  disk_cache::turn_on(true);
  const auto cold = surfaces();
  EXPECT_EQ(disk_cache::size().files, postures.size());
  const auto warm = surfaces();
  disk_cache::turn_on(false);
  unsetenv("LOOSEFIT_CACHE");
  EXPECT_EQ(cold, without);
  EXPECT_EQ(warm, without);
}

}  // namespace
}  // namespace loosefit::flesh
