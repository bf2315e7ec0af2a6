#include <gtest/gtest.h>

#include <set>

#include "loosefit/base/error.h"
#include "loosefit/body/body_fit.h"
#include "loosefit/body/landmarks.h"
#include "loosefit/body/skeleton_pose.h"
#include "loosefit/geometry/exact_intersection.h"
#include "support/body_fixture.h"

namespace loosefit::body {
namespace {

constexpr int kWristVertex = 10208;

BodyFit study_child(double chest, double waist, double hip) {
  BodySpec spec;
  spec.sex = 0.4, spec.age = 10, spec.height = 1.40;
  spec.measurements = {{"chest", chest}, {"waist", waist}, {"hip", hip}};
  return fit_body(body_model(), spec, BodyDetail::coarse);
}

// The coarse surface in a posture given by bone rotations.
std::vector<Vec3> pose_coarse(const RestBody& rest, const BoneRotations& rotations) {
  const BodyData& data = body_model().data();
  const auto maps = blend_bones(pose_bones(data, rest.joints, rotations), data.skin);
  std::vector<Vec3> posed;
  for (std::size_t v = 0; v < maps.size(); ++v)
    posed.push_back(maps[v] * rest.surface.vertices[v].homogeneous());
  return posed;
}

void expect_point(const Vec3& found, double x, double y, double z, double tolerance_dm) {
  EXPECT_LT((found - from_decimetres(x, y, z)).cwiseAbs().maxCoeff(), tolerance_dm * 0.1)
      << found.transpose();
}

TEST(Posture, OneBoneGolden) {
  BodyParameters e;
  e.sex = 0.4, e.age = 10, e.height = 0.587;
  const RestBody rest = body_model().rest(e, BodyDetail::coarse);
  expect_point(rest.surface.vertices[kWristVertex], 3.7944, 0.3771, 1.4004, 0.0002);
  // -20° about the forward axis, which is -y here.
  const Mat3 turn = Eigen::AngleAxisd(radians(-20), -Vec3::UnitY()).toRotationMatrix();
  const auto posed = pose_coarse(rest, {{"upperarm01.L", turn}});
  expect_point(posed[kWristVertex], 2.8357, -0.3178, 1.4004, 0.0003);
}

TEST(Posture, ArmAbductionGoldens) {
  const struct {
    double chest, waist, hip, rest_deg, x, y, z;
  } kChildren[] = {{0.63, 0.55, 0.68, 41.937, 2.7002, -0.4486, 1.4009},
                   {0.75, 0.72, 0.80, 41.071, 2.7589, -0.4181, 1.3979}};
  const BodyData& data = body_model().data();
  for (const auto& child : kChildren) {
    const BodyFit fit = study_child(child.chest, child.waist, child.hip);
    const RestBody rest = body_model().rest(fit.parameters, BodyDetail::coarse);
    EXPECT_NEAR(degrees(rest_arm_abduction(data, rest.joints)), child.rest_deg, 0.05);
    const Posture arms_down{radians(20), 0, 0};
    const auto posed = pose_coarse(rest, posture_rotations(data, rest.joints, arms_down));
    expect_point(posed[kWristVertex], child.x, child.y, child.z, 0.006);  // fitted to 4 digits
  }
}

TEST(Posture, IdentityReturnsTheRestMesh) {
  const RestBody rest = body_model().rest({}, BodyDetail::coarse);
  const auto posed = pose_coarse(rest, {});
  for (std::size_t v = 0; v < posed.size(); ++v) {
    ASSERT_LT((posed[v] - rest.surface.vertices[v]).norm(), 1e-12);
  }
}

TEST(Posture, RestToPosedMapsCarryTheRestBody) {
  const BodyParameters adult;
  const BodyModel& model = body_model();
  const Body rest = model.build(adult, model.rest_posture(adult));
  const Body posed = model.build(adult, {radians(25), radians(20), 0.3});
  double worst = 0;
  for (std::size_t v = 0; v < rest.surface.vertices.size(); ++v) {
    const Vec3 carried = posed.pose_from_rest[v] * rest.surface.vertices[v].homogeneous();
    worst = std::max(worst, (carried - posed.surface.vertices[v]).norm());
  }
  EXPECT_LT(worst, 1e-9);
  double floor = 1;
  for (const auto& p : posed.surface.vertices) floor = std::min(floor, p.z());
  EXPECT_NEAR(floor, 0, 1e-12);
}

TEST(Posture, OfAShapeIsThatOfItsParameters) {
  const BodyModel& model = body_model();
  const Posture posture{radians(8), radians(10), 0.2, 0, 0.66, 0, 1};
  const Body built = model.build(BodyParameters{}, posture);
  const BodyShape shape = model.shape({});
  const Body posed = model.posed(shape, posture);
  EXPECT_EQ(posed.surface.vertices, built.surface.vertices);
  EXPECT_EQ(posed.measured, built.measured);
  EXPECT_EQ(posed.landmark_vertex, built.landmark_vertex);
  EXPECT_EQ(posed.joints, built.joints);
  EXPECT_EQ(model.vertices(shape, posture), built.surface.vertices);
}

TEST(Posture, ArmsHangAtTheAngleAskedFor) {
  for (const double angle : {15., 25., 40., 60.}) {
    const Body body = body_model().build({}, {radians(angle), 0, 0});
    const Vec3 arm = body.joints.at("elbow_L") - body.joints.at("shoulder_L");
    EXPECT_NEAR(degrees(std::atan2(arm.x(), -arm.z())), angle, 0.01);
    const Vec3 right = body.joints.at("elbow_R") - body.joints.at("shoulder_R");
    EXPECT_LT((Vec3(-right.x(), right.y(), right.z()) - arm).norm(), 1e-9);
  }
}

TEST(Posture, BackLeansByTheBendAskedFor) {
  const auto lean = [](double bend) {
    const Body body = body_model().build({}, {radians(25), radians(bend), 0});
    const Vec3 back = body.landmarks.at("c7") - body.landmarks.at("back_waist");
    return degrees(std::atan2(-back.y(), back.z()));
  };
  const double upright = lean(0);
  for (const double bend : {10., 20., 30., 45.})
    EXPECT_NEAR(lean(bend) - upright, bend, 1.5) << bend;
}

TEST(Posture, SittingBringsThighsLevelAndFeetDown) {
  const Body body = body_model().build({}, {radians(25), 0, 1});
  const Vec3 thigh = body.joints.at("knee_L") - body.joints.at("hip_L");
  EXPECT_LT(thigh.y(), -0.3);
  EXPECT_NEAR(thigh.z() / thigh.norm(), 0, 0.2);
  EXPECT_LT(body.joints.at("ankle_L").z(), 0.15);
  EXPECT_LT(body.landmarks.at("crown").z(), 1.45);
}

// Toes and lips touch in this model; the test asks about trunk and arms.
TEST(Posture, ArmsAtTwentyDegreesDoNotCutTheTrunkOfTheStudyChildren) {
  const struct { double chest, waist, hip; } kChildren[] = {{0.63, 0.55, 0.68}, {0.75, 0.72, 0.80}};
  for (const auto& child : kChildren) {
    const BodyFit fit = study_child(child.chest, child.waist, child.hip);
    const Body body = body_model().build(fit.parameters, {radians(20), 0, 0});
    int cuts = 0;
    const auto crossings =
        geometry::self_intersections(body.surface.vertices, body.surface.triangles);
    for (const auto& [a, b] : crossings) {
      std::set<Segment> segments;
      for (const int t : {a, b}) {
        segments.insert(body.segment[std::size_t(body.surface.triangles[std::size_t(t)][0])]);
      }
      cuts += !segments.contains(Segment::foot) && !segments.contains(Segment::head);
    }
    EXPECT_EQ(cuts, 0);
  }
}

TEST(Posture, BodyIsMirrorSymmetric) {
  const BodyData& data = body_model().data();
  const Body body = body_model().build({}, {});
  double worst = 0;
  for (int v = 0; v < data.body_vertices; ++v) {
    const Vec3& p = body.surface.vertices[std::size_t(v)];
    const Vec3& q = body.surface.vertices[std::size_t(data.mirror[std::size_t(v)])];
    worst = std::max(worst, (Vec3(-q.x(), q.y(), q.z()) - p).norm());
  }
  EXPECT_LT(worst, 1e-9);
}

TEST(Posture, ImpossibleAnglesAreRefused) {
  EXPECT_THROW(body_model().build({}, {radians(200), 0, 0}), InvalidInput);
  EXPECT_THROW(body_model().build({}, {radians(25), radians(170), 0}), InvalidInput);
  EXPECT_THROW(body_model().build({}, {radians(25), 0, -0.5}), InvalidInput);
  EXPECT_THROW(body_model().build({}, {std::nan(""), 0, 0}), InvalidInput);
}

}  // namespace
}  // namespace loosefit::body
