#include "loosefit/geometry/nearest_rotation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace loosefit::geometry {
namespace {

Mat3 turn_about(const Vec3& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

TEST(NearestRotation, IsTheRotationItselfAndNeverAMirrorImage) {
  const Mat3 turn = turn_about(Vec3(1, 2, 3), 2.5);
  EXPECT_NEAR((nearest_rotation(turn) - turn).norm(), 0, 1e-12);
  // Rotations by ±0.3 about one axis: their mean is the unturned frame.
  const Mat3 sum = turn_about(Vec3::UnitX(), 0.3) + turn_about(Vec3::UnitX(), -0.3);
  EXPECT_NEAR((nearest_rotation(sum) - Mat3::Identity()).norm(), 0, 1e-12);
  const Mat3 mirrored = Vec3(3, 2, -0.1).asDiagonal();
  EXPECT_NEAR((nearest_rotation(mirrored) - Mat3::Identity()).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace loosefit::geometry
