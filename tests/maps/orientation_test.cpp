// Orientation of cloth against the body: known rotations of a rigid shell
// (docs/theory/sensor_metrics.md 10).
#include "loosefit/maps/orientation.h"

#include <gtest/gtest.h>

#include <random>

#include "loosefit/base/error.h"
#include "loosefit/body/body_frame.h"
#include "loosefit/maps/compute_maps.h"
#include "loosefit/maps/orientation_error.h"
#include "support/tube_garment.h"
#include "support/wall_and_patch.h"

namespace loosefit::maps {
namespace {

using testing::turn_about;
constexpr double kTenth = 0.1;  // [deg], the accuracy asked of a rigid shell

/// A swing by `tilt` about the tangent at `azimuth` from s, after a twist: all in degrees.
struct Turn {
  double tilt, azimuth, twist;
};
Mat3 rotation(const Turn& t) {
  const Vec3 axis(std::cos(radians(t.azimuth)), std::sin(radians(t.azimuth)), 0);
  return turn_about(axis, radians(t.tilt)) * turn_about(Vec3::UnitZ(), radians(t.twist));
}

TEST(Orientation, TiltAboutTheSensorsAxesIsTheSameTiltSeenFromTheSensor) {
  std::mt19937_64 rng(3);
  std::uniform_real_distribution<double> tilt(0, 80), turn(-170, 170);
  for (int draw = 0; draw < 200; ++draw) {
    const Turn t{tilt(rng), turn(rng), turn(rng)};
    const Mat3 r = rotation(t);
    const Orientation o = orientation_of(r);
    const Vec3 in_sensor = r.transpose() * Vec3(o.tilt_sagittal, o.tilt_lateral, 0);
    EXPECT_NEAR(o.tilt_across(), in_sensor.x(), 1e-9);
    EXPECT_NEAR(o.tilt_along(), in_sensor.y(), 1e-9);
    EXPECT_NEAR(in_sensor.z(), 0, 1e-9);
  }
}

TEST(OrientationError, TurnHasTheSizeOfTheErrorAndItsSigns) {
  std::mt19937_64 rng(5);
  std::uniform_real_distribution<double> any(-1, 1), size(0.01, 2.5);
  for (int draw = 0; draw < 200; ++draw) {
    const Mat3 then = rotation({60 * any(rng), 170 * any(rng), 170 * any(rng)});
    const Vec3 axis = Vec3(any(rng), any(rng), any(rng)).normalized();
    const double angle = size(rng);
    // The sensor turns about an axis that is fixed in it.
    const Mat3 now = then * turn_about(axis, angle);
    const Vec3 turn = calibrated_turn(now, then);
    EXPECT_LT((turn - angle * axis).norm(), 1e-7);
    EXPECT_NEAR(turn.norm(), calibrated_error(now, then), 1e-7);
  }
}

class KnownTurn : public ::testing::TestWithParam<Turn> {};

TEST_P(KnownTurn, ComesApartIntoItsSwingAndTwist) {
  const Turn t = GetParam();
  const Orientation o = orientation_of(rotation(t));
  EXPECT_NEAR(degrees(o.angular_deviation), t.tilt, 1e-9);
  EXPECT_NEAR(degrees(o.tilt_sagittal), t.tilt * std::cos(radians(t.azimuth)), 1e-9);
  EXPECT_NEAR(degrees(o.tilt_lateral), t.tilt * std::sin(radians(t.azimuth)), 1e-9);
  EXPECT_NEAR(degrees(o.twist), t.twist, 1e-9);
  EXPECT_NEAR(std::cos(o.rotation / 2),
              std::cos(radians(t.tilt) / 2) * std::cos(radians(t.twist) / 2), 1e-12);
}

TEST_P(KnownTurn, OfARigidShellIsReadFromTheMap) {
  const Turn t = GetParam();
  if (t.tilt > 80) return;  // the shell would show the wall its edge
  const garment::Garment patch = testing::patch_garment(0.06, 0.01);
  const Mat3 frame = testing::wall_frame();
  const auto positions = testing::before_wall(patch, 0.05, frame * rotation(t) * frame.transpose());
  const WornGarment worn = relate(patch, positions, testing::wall_body());
  const auto maps = make_maps("orientation", {patch, positions, worn});
  ASSERT_EQ(maps.size(), 4u);
  const double total =
      degrees(2 * std::acos(std::cos(radians(t.tilt) / 2) * std::cos(radians(t.twist) / 2)));
  for (int v = 0; v < patch.vertex_count; ++v) {
    EXPECT_NEAR(maps[0].values[v], t.tilt * std::cos(radians(t.azimuth)), kTenth);
    EXPECT_NEAR(maps[1].values[v], t.tilt * std::sin(radians(t.azimuth)), kTenth);
    EXPECT_NEAR(maps[2].values[v], t.twist, kTenth);
    EXPECT_NEAR(maps[3].values[v], total, kTenth);
    EXPECT_NEAR(degrees(angle_between(worn.normals[v], worn.partners[v].normal)), t.tilt, kTenth);
  }
}
INSTANTIATE_TEST_SUITE_P(Turns, KnownTurn,
                         ::testing::Values(Turn{12, 0, 0}, Turn{12, 90, 0}, Turn{0, 0, 25},
                                           Turn{0, 0, -140}, Turn{15, 30, 25}, Turn{40, 200, -60},
                                           Turn{0.001, -70, 0.002}, Turn{70, 135, 90},
                                           Turn{150, 20, 10}));

TEST(Orientation, TiltIsPositiveForANormalThatLeansDownAndToTheWearersRightOnTheBack) {
  const garment::Garment patch = testing::patch_garment(0.04, 0.01);
  const auto tilts = [&](const Vec3& normal) {
    const Mat3 turn =
        Eigen::Quaterniond::FromTwoVectors(Vec3::UnitY(), normal.normalized()).toRotationMatrix();
    const auto positions = testing::before_wall(patch, 0.05, turn);
    const WornGarment worn = relate(patch, positions, testing::wall_body());
    const auto maps = make_maps("orientation", {patch, positions, worn});
    return Vec2(maps[0].values[0], maps[1].values[0]);
  };
  const double angle = degrees(std::atan(0.2));
  EXPECT_NEAR((tilts(Vec3(0, 1, -0.2)) - Vec2(angle, 0)).norm(), 0, 1e-6);
  EXPECT_NEAR((tilts(Vec3(-0.2, 1, 0)) - Vec2(0, angle)).norm(), 0, 1e-6);
}

TEST(Orientation, OfOppositeNormalsHasNoTwist) {
  const Orientation o = orientation_of(turn_about(Vec3::UnitX(), kPi));
  EXPECT_NEAR(o.angular_deviation, kPi, 1e-9);
  EXPECT_NEAR(o.rotation, kPi, 1e-9);
  EXPECT_TRUE(std::isnan(o.twist));
  EXPECT_TRUE(std::isnan(o.tilt_sagittal));
}

TEST(RotationAngle, IsExactNearZeroAndNearAHalfTurn) {
  for (const double angle : {0.0, 1e-9, 1e-4, 1.0, kPi - 1e-7, kPi})
    EXPECT_NEAR(rotation_angle(turn_about(Vec3(1, 2, 3), angle)), angle, 1e-14 + 1e-8 * angle);
  EXPECT_NEAR(rotation_angle(turn_about(Vec3(1, 2, 3), 1e-9)), 1e-9, 1e-15);
}

// A tube whose grain winds round a cylinder at 20° to the axis, both ways: the twist of the map.
TEST(Orientation, OfAHelicalTubeIsItsTwistAlone) {
  constexpr double kRadius = 0.12, kCloth = 0.13;
  body::Body body = testing::cylinder_body(kRadius, 1.0, 360, 20);
  body.joints["pelvis"] = Vec3(0, 0, 0.1);
  body.joints["neck"] = Vec3(0, 0, 0.9);
  const garment::Garment tube = testing::tube_garment(2 * kPi * kCloth, 0.3, 180, 40);
  for (const double pitch : {20.0, -20.0}) {
    const double slope = std::tan(radians(pitch));
    const drape::Drape d = testing::settled_drape(tube, [&](const Vec2& uv) {
      const double angle = (uv.x() + slope * uv.y()) / kCloth;
      return Vec3(kCloth * std::cos(angle), kCloth * std::sin(angle), 0.3 + uv.y());
    });
    const auto maps = compute_maps(tube, d, body, {"orientation"});
    ASSERT_EQ(maps.size(), 4u);
    for (int v = 180; v < tube.vertex_count - 180; ++v) {  // the rim's normals lean
      EXPECT_NEAR(maps[0].values[v], 0, kTenth);
      EXPECT_NEAR(maps[1].values[v], 0, kTenth);
      EXPECT_NEAR(maps[2].values[v], -pitch, kTenth);  // winding to the left seen from outside: ccw
      EXPECT_NEAR(maps[3].values[v], 20, kTenth);
    }
  }
}

TEST(Orientation, TakesTheGrainOfTheVerticesOwnPanelAtASeam) {
  garment::Garment patch = testing::patch_garment(0.04, 0.01);
  patch.panel_names.push_back("right");
  // Right of the middle another panel, cut a quarter turn off the grain.
  std::vector<char> left(patch.vertex_count, 0);
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    double u = 0;
    for (const Vec2& uv : patch.triangle_uv[t]) u += uv.x() / 3;
    if (u <= 0)
      for (int v : patch.triangles[t]) left[v] = 1;
    else
      patch.triangle_panel[t] = 1;
    if (u > 0)
      for (Vec2& uv : patch.triangle_uv[t]) uv = Vec2(-uv.y(), uv.x());
  }
  for (int v = 0; v < patch.vertex_count; ++v) patch.vertex_panel[v] = left[v] ? 0 : 1;
  const auto positions = testing::before_wall(patch, 0.05);
  const WornGarment worn = relate(patch, positions, testing::wall_body());
  const auto twist = make_maps("orientation", {patch, positions, worn})[2].values;
  for (int v = 0; v < patch.vertex_count; ++v)
    EXPECT_NEAR(std::abs(twist[v]), left[v] ? 0 : 90, 1e-6) << v;
}

TEST(Orientation, IsNotDefinedWithoutASegmentAxis) {
  body::Body body = testing::wall_body();
  body.joints.clear();
  const garment::Garment patch = testing::patch_garment(0.04, 0.01);
  const auto positions = testing::before_wall(patch, 0.02);
  const WornGarment worn = relate(patch, positions, body);
  for (const PerformanceMap& map : make_maps("orientation", {patch, positions, worn}))
    for (double value : map.values) EXPECT_TRUE(std::isnan(value));
}

TEST(TriangleFrame, IsNoneWithoutArea) {
  garment::Garment patch = testing::patch_garment(0.02, 0.01);
  auto positions = testing::before_wall(patch, 0);
  EXPECT_TRUE(triangle_frame(patch, 0, positions).isApprox(testing::wall_frame(), 1e-12));
  const Vec2 diagonal = Vec2(1, 1).normalized();
  const Mat3 turned = triangle_frame(patch, 0, positions, diagonal);
  EXPECT_NEAR((turned.col(1) - (Vec3::UnitZ() - Vec3::UnitX()).normalized()).norm(), 0, 1e-12);
  patch.triangle_uv[0][2] = patch.triangle_uv[0][1];
  EXPECT_TRUE(triangle_frame(patch, 0, positions).hasNaN());
}

}  // namespace
}  // namespace loosefit::maps
