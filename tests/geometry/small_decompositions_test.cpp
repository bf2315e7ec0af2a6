#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "loosefit/geometry/least_squares.h"
#include "loosefit/geometry/principal_axes.h"
#include "loosefit/geometry/rotation_between.h"

namespace loosefit::geometry {
namespace {

TEST(RotationBetween, BringsOneDirectionIntoTheOtherByTheShortestTurn) {
  const Vec3 from(1, 2, 3), to(-2, 0.5, 1);
  const Eigen::Quaterniond turn = rotation_between(from, to);
  EXPECT_NEAR((turn * from.normalized() - to.normalized()).norm(), 0, 1e-14);
  const double angle = std::acos(from.normalized().dot(to.normalized()));
  EXPECT_NEAR(Eigen::AngleAxisd(turn).angle(), angle, 1e-14);
  EXPECT_NEAR(turn.norm(), 1, 1e-15);
}

TEST(RotationBetween, TurnsOppositeDirectionsByHalfATurn) {
  for (const Vec3& from : {Vec3(1, 0, 0), Vec3(0, -2, 0), Vec3(0.3, -0.4, 5)}) {
    const Eigen::Quaterniond turn = rotation_between(from, -from);
    EXPECT_NEAR((turn * from + from).norm(), 0, 1e-14 * from.norm());
    EXPECT_NEAR(turn.norm(), 1, 1e-15);
  }
  EXPECT_NEAR(rotation_between(Vec3(1, 1, 1), Vec3(2, 2, 2)).w(), 1, 1e-15);
}

TEST(PrincipalAxes, AreThoseThatTheMatrixWasMadeOf) {
  const Mat3 axes = Eigen::AngleAxisd(0.7, Vec3(1, -1, 2).normalized()).toRotationMatrix();
  const PrincipalAxes found = principal_axes(axes * Vec3(-1, 2, 5).asDiagonal() * axes.transpose());
  EXPECT_NEAR((found.values - Vec3(-1, 2, 5)).norm(), 0, 1e-13);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(std::abs(found.axes.col(k).dot(axes.col(k))), 1, 1e-13);
}

TEST(LeastSquares, MeetsTheNormalEquationsAndBearsDependentColumns) {
  Eigen::MatrixXd a(4, 2);
  a << 1, 0, 1, 1, 1, 2, 1, 3;
  const Eigen::Vector4d b(1, 3, 4, 4);  // the line 1.5 + x by hand
  EXPECT_NEAR((least_squares(a, b) - Eigen::Vector2d(1.5, 1)).norm(), 0, 1e-13);
  a.col(1) = 2 * a.col(0);
  const Eigen::VectorXd x = least_squares(a, b);
  EXPECT_TRUE(x.allFinite());
  EXPECT_NEAR((a.transpose() * (a * x - b)).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace loosefit::geometry
