#include "loosefit/body/body_frame.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "support/tube_garment.h"
#include "support/wall_and_patch.h"

namespace loosefit::body {
namespace {

using testing::turn_about;

TEST(SegmentAxes, RunFromTheFarEndOfALimbToTheNearOne) {
  Body body = testing::cylinder_body(0.05, 0.6, 12, 6);
  body.joints["shoulder_L"] = Vec3(0, 0.1, 0.6);
  body.joints["elbow_L"] = Vec3(0, 0, 0.3);
  body.joints["wrist_L"] = Vec3(0.3, 0, 0.3);
  body.side.assign(body.side.size(), 1);
  for (std::size_t v = 0; v < body.segment.size(); ++v)
    body.segment[v] = body.surface.vertices[v].z() > 0.3 ? Segment::upper_arm : Segment::forearm;
  const auto axes = segment_axes(body);
  for (std::size_t v = 0; v < axes.size(); ++v) {
    const Vec3 expected =
        body.segment[v] == Segment::upper_arm ? Vec3(0, 0.1, 0.3).normalized() : Vec3(-1, 0, 0);
    EXPECT_NEAR((axes[v] - expected).norm(), 0, 1e-12);
  }
  body.side.assign(body.side.size(), -1);  // nothing is known of the right arm
  for (const Vec3& axis : segment_axes(body)) EXPECT_EQ(axis.norm(), 0);
}

TEST(SegmentAxes, OfTheTrunkLeanWithTheSkin) {
  Body body = testing::cylinder_body(0.15, 0.6, 12, 6);
  EXPECT_EQ(segment_axes(body)[0].norm(), 0);
  body.joints["pelvis"] = Vec3(0, 0, 0.1);
  body.joints["neck"] = Vec3(0, -0.1, 0.5);
  EXPECT_NEAR((segment_axes(body)[0] - Vec3(0, -0.1, 0.4).normalized()).norm(), 0, 1e-12);
  // Bent by up to 40° to its upper end: the axis follows, vertex by vertex, whatever the joints.
  body.pose_from_rest.resize(body.segment.size());
  const auto bend = [&](std::size_t v) {
    return turn_about(Vec3::UnitX(), radians(40) * body.surface.vertices[v].z() / 0.6);
  };
  for (std::size_t v = 0; v < body.segment.size(); ++v)
    body.pose_from_rest[v] << bend(v), Vec3(0, 0, 0.01);
  const auto axes = segment_axes(body);
  for (std::size_t v = 0; v < axes.size(); ++v)
    EXPECT_NEAR((axes[v] - bend(v) * Vec3::UnitZ()).norm(), 0, 1e-12);
}

TEST(SurfaceFrame, OnTheBackPointsRightUpAndBackwards) {
  const SurfaceFrame frame = surface_frame(Vec3::UnitY(), Vec3(0, 0.3, 1).normalized());
  EXPECT_TRUE(frame.has_direction);
  EXPECT_NEAR((frame.axes - testing::wall_frame()).norm(), 0, 1e-12);
  EXPECT_NEAR(frame.axes.determinant(), 1, 1e-12);
}

TEST(SurfaceFrame, GivesNoDirectionAlongTheNormal) {
  const auto at = [](double inclination) {
    return surface_frame(Vec3::UnitZ(), Vec3(std::sin(inclination), 0, std::cos(inclination)));
  };
  EXPECT_TRUE(at(1.01 * kLeastInclination).has_direction);
  for (const SurfaceFrame& frame :
       {at(0.99 * kLeastInclination), at(0), surface_frame(Vec3::UnitZ(), Vec3::Zero())}) {
    EXPECT_FALSE(frame.has_direction);
    EXPECT_NEAR((frame.axes.transpose() * frame.axes - Mat3::Identity()).norm(), 0, 1e-12);
    EXPECT_NEAR(frame.axes.determinant(), 1, 1e-12);
    EXPECT_NEAR(frame.axes(2, 2), 1, 1e-12);
  }
}

TEST(SkinPoint, MovesAndTurnsWithTheBody) {
  Body body = testing::cylinder_body(0.1, 1.0, 40, 20);
  body.joints["pelvis"] = Vec3(0, 0, 0.1);
  body.joints["neck"] = Vec3(0, 0, 0.9);
  const geometry::ClosestPoint at =
      geometry::ClosestPointTree(body.surface).query(Vec3(0.13, 0.05, 0.43));
  const SkinPoint point = skin_point(body, segment_axes(body), at);
  EXPECT_TRUE(point.has_direction);
  EXPECT_NEAR((position_of(point, body) - at.point).norm(), 0, 1e-12);
  const Mat3 frame = frame_of(point, body).axes;
  EXPECT_NEAR((frame.col(1) - Vec3::UnitZ()).norm(), 0, 1e-9);
  const Mat3 turn = turn_about(Vec3(1, -2, 0.4), 1.2);
  const Vec3 move(0.1, 0.3, -0.2);
  const Body there = testing::moved(body, turn, move);
  EXPECT_NEAR((position_of(point, there) - (turn * at.point + move)).norm(), 0, 1e-12);
  EXPECT_NEAR((frame_of(point, there).axes - turn * frame).norm(), 0, 1e-9);
}

TEST(SkinPoint, FollowsTheTwistOfTheSkin) {
  // A forearm whose skin turns about its axis by 1 rad per 0.5 m: lines along it lean by r·2 rad/m.
  Body body = testing::cylinder_body(0.04, 0.5, 60, 50);
  body.joints["pelvis"] = Vec3(0, 0, 0);
  body.joints["neck"] = Vec3(0, 0, 0.5);
  Body twisted = body;
  for (std::size_t v = 0; v < body.normals.size(); ++v) {
    const Mat3 turn = turn_about(Vec3::UnitZ(), 2 * body.surface.vertices[v].z());
    twisted.surface.vertices[v] = turn * body.surface.vertices[v];
    twisted.normals[v] = turn * body.normals[v];
  }
  const geometry::ClosestPoint at =
      geometry::ClosestPointTree(body.surface).query(Vec3(0.05, 0.02, 0.2));
  const SkinPoint point = skin_point(body, segment_axes(body), at);
  const SurfaceFrame frame = frame_of(point, twisted);
  const double lean = std::atan2(frame.axes.col(1).head<2>().norm(), frame.axes(2, 1));
  EXPECT_NEAR(lean, std::atan(0.04 * 2), 0.002);
  EXPECT_TRUE(frame.has_direction);
}

TEST(SameWearer, IsAskedForBySurface) {
  const Body body = testing::cylinder_body(0.1, 1.0, 12, 4);
  EXPECT_NO_THROW(require_same_wearer(body, testing::moved(body, Mat3::Identity(), {1, 0, 0})));
  EXPECT_THROW(require_same_wearer(body, testing::cylinder_body(0.1, 1.0, 12, 5)), InvalidInput);
  Body other = body;
  std::swap(other.surface.triangles[0][0], other.surface.triangles[0][1]);
  EXPECT_THROW(require_same_wearer(body, other), InvalidInput);
}

}  // namespace
}  // namespace loosefit::body
