#include "loosefit/validate/other_bodies.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/validate/bent_arm.h"
#include "support/shapes.h"

namespace loosefit::validate {
namespace {

/// A trunk with two arms beside it, upright cylinders.
body::Body two_arms(double lifted) {
  body::Body body;
  for (const int side : {0, 1, -1}) {
    const geometry::TriangleMesh part =
        support::cylinder(side == 0 ? 0.15 : 0.04, 0.9, 1.4, 10, 24);
    const int first = static_cast<int>(body.surface.vertices.size());
    for (const Vec3& p : part.vertices) {
      body.surface.vertices.push_back(p + Vec3(0.25 * side, 0, side == 0 ? 0 : lifted));
      body.segment.push_back(side == 0 ? body::Segment::torso : body::Segment::upper_arm);
      body.side.push_back(side);
    }
    for (const Triangle& t : part.triangles)
      body.surface.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  body.joints = {{"shoulder_L", {0.25, 0, 1.4 + lifted}}, {"shoulder_R", {-0.25, 0, 1.4 + lifted}}};
  body.landmarks = {{"hps_L", {0.05, 0, 1.42}}, {"acromion_L", {0.20, 0, 1.38}}};
  body.measured = {
      {"armpit_level", 1.3}, {"waist_level", 1.05}, {"shoulder_slope", std::atan2(0.04, 0.15)}};
  body.normals = geometry::vertex_normals(body.surface.vertices, body.surface.triangles);
  return body;
}

TEST(Halves, TakeTheRightArmOfOneAndAllElseOfTheOther) {
  const body::Body down = two_arms(0), up = two_arms(0.3), mixed = halves(down, up);
  for (std::size_t v = 0; v < mixed.surface.vertices.size(); ++v)
    EXPECT_EQ(mixed.surface.vertices[v], (mixed.side[v] < 0 ? up : down).surface.vertices[v]);
  EXPECT_EQ(mixed.joints.at("shoulder_R").z(), 1.7);
  EXPECT_EQ(mixed.joints.at("shoulder_L").z(), 1.4);
}

TEST(ShoulderSlope, TurnsTheLineFromNeckToTipAndCarriesTheArms) {
  const body::Body plain = two_arms(0);
  const double slope = plain.measured.at("shoulder_slope"), more = radians(6.0);
  const body::Body sloped = with_shoulder_slope(plain, more);
  const double drop = 0.15 * (std::tan(slope + more) - std::tan(slope));
  EXPECT_NEAR(sloped.measured.at("shoulder_slope"), slope + more, 1e-15);
  EXPECT_NEAR(sloped.joints.at("shoulder_L").z(), 1.4 - drop, 1e-12);
  for (std::size_t v = 0; v < plain.surface.vertices.size(); ++v) {
    const Vec3 &a = plain.surface.vertices[v], &b = sloped.surface.vertices[v];
    EXPECT_EQ(a.head<2>(), b.head<2>());
    if (plain.side[v] != 0) {
      EXPECT_NEAR(a.z() - b.z(), drop, 1e-12);
    } else if (std::abs(a.x()) < 0.05 || a.z() < 1.05) {
      EXPECT_EQ(a.z(), b.z()) << "under the neck and below the waist";
    }
  }
}

// Ways and movements of a sloped wearer: none may lead back to the shoulders of the model.
TEST(ShoulderSlope, IsThatOfEveryBodyOfAWay) {
  const double more = radians(6.0);
  const body::BodyPath lifting = [](double share) {
    return body::PosedBody(two_arms(0.3 * share));
  };
  const body::BodyPath sloped = sloped_way(lifting, more), plain = sloped_way(lifting, 0);
  for (const double share : {0.0, 0.5, 1.0}) {
    const body::Body model = two_arms(0.3 * share);
    EXPECT_EQ(sloped(share)->surface.vertices, with_shoulder_slope(model, more).surface.vertices);
    EXPECT_NE(sloped(share)->surface.vertices, model.surface.vertices);
    EXPECT_EQ(plain(share)->surface.vertices, model.surface.vertices);
  }
  const body::BodyPath none = sloped_way({}, more);
  EXPECT_FALSE(none) << "a movement of a wearer who stands still";
}

TEST(BentArm, KeepsItsGirthsAndKnowsWhereItsSkinHasGone) {
  const BentArm arm;
  const body::Body straight = arm.at(0), bent = arm.at(1);
  ASSERT_EQ(straight.surface.vertices.size(), bent.surface.vertices.size());
  for (std::size_t v = 0; v < bent.surface.vertices.size(); v += 37) {
    const Vec3 moved = bent.pose_from_rest[v].leftCols<3>() * straight.surface.vertices[v] +
                       bent.pose_from_rest[v].col(3);
    EXPECT_LT((moved - bent.surface.vertices[v]).norm(), 1e-12);
  }
  const Vec3 upper = bent.joints.at("elbow_L") - bent.joints.at("shoulder_L"),
             fore = bent.joints.at("wrist_L") - bent.joints.at("elbow_L");
  EXPECT_NEAR(degrees(std::asin(upper.normalized().z())), 10, 3) << "the elbow is rounded";
  EXPECT_LT(fore.z(), 0);
  // Frusta of cones: V = π L (a² + a b + b²)/3; Pappus for the elbow, whose middle keeps its
  // length.
  const auto frustum = [](double length, double a, double b) {
    return kPi * length * (a * a + a * b + b * b) / 3;
  };
  const double volume = frustum(arm.upper_length, arm.shoulder_radius, arm.elbow_radius) +
                        frustum(arm.fore_length, arm.elbow_radius, arm.wrist_radius);
  EXPECT_NEAR(geometry::enclosed_volume(straight.surface), volume, 2e-3 * volume);
  EXPECT_NEAR(geometry::enclosed_volume(bent.surface), volume, 2e-3 * volume);
}

TEST(BentArm, SleeveHasTheEaseAtEveryStationOfTheArm) {
  const BentArm arm;
  const pattern::Pattern sleeve = arm.sleeve(0.15, 0.06, 0.46);
  ASSERT_EQ(sleeve.panels.size(), 2u);
  const auto& corner = sleeve.panels[0].vertices;
  EXPECT_NEAR(2 * (corner[1].x() - corner[0].x()), 1.15 * 2 * kPi * arm.radius(0.46), 1e-12);
  EXPECT_NEAR(2 * (corner[2].x() - corner[5].x()), 1.15 * 2 * kPi * arm.elbow_radius, 1e-12);
  EXPECT_NEAR(2 * (corner[3].x() - corner[4].x()), 1.15 * 2 * kPi * arm.radius(0.06), 1e-12);
  for (const pattern::Panel& panel : sleeve.panels)
    EXPECT_NEAR(panel.rotation.determinant(), 1, 1e-12);
}

}  // namespace
}  // namespace loosefit::validate
