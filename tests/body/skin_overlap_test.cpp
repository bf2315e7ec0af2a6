#include "loosefit/body/skin_overlap.h"

#include <gtest/gtest.h>

#include "loosefit/geometry/closest_point.h"
#include "loosefit/geometry/exact_intersection.h"
#include "support/body_fixture.h"
#include "support/shapes.h"

namespace loosefit {
namespace {

using MotionMap = Eigen::Matrix<double, 3, 4>;

/// A trunk and an arm, both balls, `gap` between them at (0.15, 0, 1) m; in rest they were 0.2 m
/// farther apart.
struct Balls {
  Body body;
  std::vector<Vec3> rest;
  int trunk_vertices = 0;
  explicit Balls(double gap) {
    body.surface = support::sphere(0.15, 60, 120);
    trunk_vertices = static_cast<int>(body.surface.vertices.size());
    const TriangleMesh arm = support::sphere(0.08, 40, 80);
    for (const Vec3& p : arm.vertices)
      body.surface.vertices.push_back(p + Vec3(0.15 + gap + 0.08, 0, 0));
    for (Triangle t : arm.triangles) {
      for (int& v : t) v += trunk_vertices;
      body.surface.triangles.push_back(t);
    }
    for (Vec3& p : body.surface.vertices) p[2] += 1;
    rest = body.surface.vertices;
    body.pose_from_rest.assign(rest.size(), MotionMap());
    for (int v = 0; v < static_cast<int>(rest.size()); ++v) {
      const bool arm_skin = v >= trunk_vertices;
      body.segment.push_back(arm_skin ? Segment::upper_arm : Segment::torso);
      body.pose_from_rest[v] << Mat3::Identity(), Vec3(arm_skin ? -0.2 : 0, 0, 0);
      if (arm_skin) rest[v][0] += 0.2;
    }
    body.normals = vertex_normals(body.surface.vertices, body.surface.triangles);
    body.joints["shoulder_L"] = Vec3(0.2, 0, 1);
    body.joints["shoulder_R"] = Vec3(-0.2, 0, 1);
  }
  /// Where the line through both centres leaves the trunk, and where it enters the arm.
  std::pair<double, double> faces() const {
    double trunk = -1, arm = 1;
    for (int v = 0; v < static_cast<int>(rest.size()); ++v) {
      const Vec3& p = body.surface.vertices[v];
      if (std::hypot(p[1], p[2] - 1) > 0.002) continue;
      if (v < trunk_vertices)
        trunk = std::max(trunk, p[0]);
      else
        arm = std::min(arm, p[0]);
    }
    return {trunk, arm};
  }
};

TEST(SkinOverlap, BothSidesGiveWayAlikeUntilTheGapIsThere) {
  Balls balls(-0.010);
  const auto [trunk_before, arm_before] = balls.faces();
  ASSERT_NEAR(arm_before - trunk_before, -0.010, 1e-9);
  const double moved = part_overlapping_skin(balls.body, balls.rest);
  const auto [trunk, arm] = balls.faces();
  EXPECT_NEAR(arm - trunk, kSkinGap, 0.35 * kSkinGap);
  EXPECT_NEAR(trunk_before - trunk, 0.5 * (0.010 + kSkinGap), 0.003);
  EXPECT_NEAR(arm - arm_before, 0.5 * (0.010 + kSkinGap), 0.003);
  EXPECT_GE(moved, 0.006);
  EXPECT_LE(moved, 0.012);
  EXPECT_TRUE(
      self_intersections(balls.body.surface.vertices, balls.body.surface.triangles).empty());
  for (std::size_t v = 0; v < balls.rest.size(); ++v)
    EXPECT_LT((balls.body.pose_from_rest[v] * balls.rest[v].homogeneous() -
               balls.body.surface.vertices[v])
                  .norm(),
              1e-12);
}

TEST(SkinOverlap, SkinThatOnlyComesNearStaysAsItIs) {
  Balls balls(0.002);
  const auto before = balls.body.surface.vertices;
  EXPECT_EQ(part_overlapping_skin(balls.body, balls.rest), 0);
  EXPECT_EQ(balls.body.surface.vertices, before);
}

TEST(SkinOverlap, ArmsThatHangCloseLeaveRoomForAShirt) {
  BodyParameters woman;
  woman.sex = 0;
  const Body body = body_model().build(woman, {radians(10.0), 0, 0});
  int cuts = 0;
  const TriangleMesh& skin = body.surface;
  for (const auto& [s, t] : self_intersections(skin.vertices, skin.triangles))
    cuts += body.segment[skin.triangles[s][0]] == Segment::torso ||
            body.segment[skin.triangles[s][0]] == Segment::upper_arm;
  EXPECT_EQ(cuts, 0);
}

}  // namespace
}  // namespace loosefit
