#include "loosefit/drape/cleft_cover.h"

#include <gtest/gtest.h>

#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/geometry/triangle_mesh.h"
#include "support/shapes.h"

namespace loosefit::drape {
namespace {

/// Two balls side by side with a cleft of this width between them, the crotch above it.
body::Body two_balls(double cleft) {
  body::Body body;
  const double radius = 0.1;
  for (const double side : {-1.0, 1.0}) {
    geometry::TriangleMesh ball = support::sphere(radius, 60, 120);
    const int first = static_cast<int>(body.surface.vertices.size());
    for (const Vec3& p : ball.vertices)
      body.surface.vertices.push_back(p + side * (radius + cleft / 2) * Vec3::UnitX());
    for (const Triangle& t : ball.triangles)
      body.surface.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  body.normals = geometry::vertex_normals(body.surface.vertices, body.surface.triangles);
  body.landmarks["crotch"] = Vec3(0, 0, 0.04);
  return body;
}

TEST(CleftCover, FillsWhatIsTooNarrowForClothAndNothingElse) {
  const geometry::TriangleMesh cover = cleft_cover(two_balls(0.002));
  ASSERT_FALSE(cover.triangles.empty());
  const geometry::ClosestPointTree tree(cover);
  EXPECT_LT(tree.signed_distance(Vec3::Zero()), -0.005);
  // Balls of 0.1 m are 8 mm from each other 25 mm off the line between their middles.
  EXPECT_GT(tree.signed_distance(Vec3(0, 0, 0.035)), 0);
  EXPECT_GT(tree.signed_distance(Vec3(0, 0.035, 0)), 0);
}

TEST(CleftCover, ThereIsNoneWhereClothHasRoomOrNoCrotchIsKnown) {
  EXPECT_TRUE(cleft_cover(two_balls(0.012)).triangles.empty());
  body::Body unknown = two_balls(0.002);
  unknown.landmarks.clear();
  EXPECT_TRUE(cleft_cover(unknown).triangles.empty());
}

double distance_to(const std::vector<geometry::TriangleMesh>& covers, const Vec3& p) {
  double nearest = 1;
  for (const geometry::TriangleMesh& cover : covers)
    nearest = std::min(nearest, geometry::ClosestPointTree(cover).signed_distance(p));
  return nearest;
}

/// Two balls, the fold between them an armpit of an arm that is raised by so many degrees.
body::Body arm_raised(double cleft, double degrees) {
  body::Body body = two_balls(cleft);
  body.landmarks["armpit_front_L"] = Vec3(0, -0.02, 0);
  body.joints["neck"] = Vec3(0, 0, 0.2);
  body.joints["pelvis"] = Vec3(0, 0, -0.4);
  body.joints["shoulder_L"] = Vec3(0.1, 0, 0.1);
  const double angle = radians(degrees);
  body.joints["elbow_L"] = Vec3(0.1, -0.3 * std::sin(angle), 0.1 - 0.3 * std::cos(angle));
  return body;
}

TEST(ArmpitCovers, AndCleftCoversLeaveFoldsThatFleshHasOpened) {
  EXPECT_FALSE(cleft_cover(two_balls(0.004)).triangles.empty());
  EXPECT_FALSE(armpit_covers(arm_raised(0.004, 80)).empty());
  EXPECT_TRUE(cleft_cover(two_balls(0.0065)).triangles.empty());
  EXPECT_TRUE(armpit_covers(arm_raised(0.0065, 80)).empty());
}

TEST(ArmpitCovers, FillAFoldAllAlongAndLeaveWhereClothHasRoom) {
  const body::Body body = arm_raised(0.002, 80);
  const std::vector<geometry::TriangleMesh> covers = armpit_covers(body);
  ASSERT_GT(covers.size(), 3u) << "a hull for every few centimetres";
  // The balls are 8 mm from each other 25 mm off the line between their middles.
  for (double along = -0.014; along <= 0.014; along += 0.001) {
    EXPECT_LT(distance_to(covers, Vec3(0, along, 0)), 0) << along;
    EXPECT_LT(distance_to(covers, Vec3(0, 0, along)), 0) << along;
  }
  EXPECT_GT(distance_to(covers, Vec3(0, 0, 0.035)), 0);
  EXPECT_GT(distance_to(covers, Vec3(0, 0.035, 0)), 0);
}

TEST(ArmpitCovers, ThereAreNoneWhereClothHasRoomOrTheArmHangsOrNoArmpitIsKnown) {
  EXPECT_TRUE(armpit_covers(arm_raised(0.012, 80)).empty());
  EXPECT_TRUE(armpit_covers(arm_raised(0.002, 40)).empty());
  EXPECT_FALSE(armpit_covers(arm_raised(0.002, 50)).empty());
  EXPECT_FALSE(armpit_covers(arm_raised(0.002, 40), true).empty());
  EXPECT_TRUE(armpit_covers(arm_raised(0.002, 30), true).empty());
  EXPECT_TRUE(raises_an_arm(arm_raised(0.002, 50)));
  EXPECT_FALSE(raises_an_arm(arm_raised(0.002, 40)));
  EXPECT_TRUE(armpit_covers(two_balls(0.002)).empty());
}

/// A ball with a disc of 6 cm beside it, 8 mm away from it where it is nearest.
body::Body head_with_ear() {
  body::Body body;
  const geometry::TriangleMesh ball = support::sphere(0.08, 60, 120);
  body.surface = ball;
  const int first = static_cast<int>(ball.vertices.size());
  for (const Vec3& p : ball.vertices)  // the same ball, flat
    body.surface.vertices.push_back(Vec3(0.05 * p.x(), 0.4 * p.y(), 0.4 * p.z()) +
                                    Vec3(0.092, 0, 0));
  for (const Triangle& t : ball.triangles)
    body.surface.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  body.normals = geometry::vertex_normals(body.surface.vertices, body.surface.triangles);
  body.segment.assign(body.surface.vertices.size(), body::Segment::head);
  body.joints["shoulder_L"] = Vec3(0.15, 0, -0.2);
  body.joints["shoulder_R"] = Vec3(-0.15, 0, -0.2);
  return body;
}

TEST(EarCovers, FillTheFurrowBehindAnEarAndNothingElse) {
  const body::Body body = head_with_ear();
  const std::vector<geometry::TriangleMesh> covers = ear_covers(body);
  ASSERT_EQ(covers.size(), 1u);
  for (const double up : {-0.012, 0.0, 0.012})
    EXPECT_LT(distance_to(covers, Vec3(0.084, 0, up)), 0) << "between ear and head";
  EXPECT_GT(distance_to(covers, Vec3(0.1, 0, 0)), 0);
  EXPECT_GT(distance_to(covers, Vec3(-0.084, 0, 0)), 0.1);
}

TEST(EarCovers, ThereAreNoneWithoutAHeadOrShoulders) {
  body::Body body = head_with_ear();
  body.segment.assign(body.surface.vertices.size(), body::Segment::torso);
  EXPECT_TRUE(ear_covers(body).empty());
  body = head_with_ear();
  body.joints.clear();
  EXPECT_TRUE(ear_covers(body).empty());
  EXPECT_TRUE(ear_covers(two_balls(0.002)).empty());
}

}  // namespace
}  // namespace loosefit::drape
