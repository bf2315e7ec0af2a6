#include "loosefit/maps/definitions/trellis_shear.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "loosefit/maps/compute_maps.h"
#include "support/tube_garment.h"

namespace loosefit::maps {
namespace {

/// F in the plane of weft and warp, laid into space by a turn.
geometry::DeformationGradient gradient(const Mat2& plane) {
  geometry::DeformationGradient f = geometry::DeformationGradient::Zero();
  f.topRows<2>() = plane;
  return Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix() * f;
}

TEST(TrellisShear, OfSimpleShearIsTheArcTangent) {
  for (const double gamma : {-1.5, -0.2, -1e-9, 0.0, 1e-9, 0.1, 0.5774, 2.0}) {
    Mat2 simple;
    simple << 1, gamma, 0, 1;
    EXPECT_NEAR(trellis_shear(gradient(simple)), std::atan(gamma), 1e-15);
  }
}

TEST(TrellisShear, IsFreeOfStretchAlongTheYarnsAndOfTheSideSeen) {
  Mat2 sheared;
  sheared << 1.2, 0.8 * std::sin(0.3), 0, 0.8 * std::cos(0.3);
  EXPECT_NEAR(trellis_shear(gradient(sheared)), 0.3, 1e-15);
  const Mat2 mirrored = Vec2(-1, 1).asDiagonal() * sheared;
  EXPECT_NEAR(trellis_shear(gradient(mirrored)), 0.3, 1e-15) << "the cloth turned over";
  const Mat2 stretched = Vec2(1.3, 0.7).asDiagonal();
  EXPECT_EQ(trellis_shear(geometry::DeformationGradient(gradient(Mat2::Identity()) * 0)), 0);
  EXPECT_NEAR(trellis_shear(gradient(stretched)), 0, 1e-15);
  EXPECT_TRUE(std::isnan(trellis_shear(geometry::DeformationGradient::Constant(std::nan("")))));
}

TEST(TrellisShear, StretchOnTheBiasShearsTheYarns) {
  // Principal stretches a and b at 45° to the yarns: tan(φ/2 + 45°) = a/b.
  const double a = 1.1, b = 0.95;
  const Mat2 turn = Eigen::Rotation2Dd(kPi / 4).toRotationMatrix();
  const Mat2 bias = turn * Vec2(a, b).asDiagonal() * turn.transpose();
  EXPECT_NEAR(trellis_shear(gradient(bias)), 2 * (std::atan(a / b) - kPi / 4), 1e-14);
}

TEST(TrellisShear, OfATwistedTubeIsThatOfItsScrewThread) {
  // Each ring is turned against the next: warp leans by γ = r θ per length.
  const double radius = 0.11, gamma = 0.2;
  const garment::Garment tube = testing::tube_garment(2 * kPi * radius, 0.2, 400, 8);
  const drape::Drape drape = testing::settled_drape(tube, [&](const Vec2& uv) {
    const double a = (uv.x() + gamma * uv.y()) / radius;
    return Vec3(radius * std::cos(a), radius * std::sin(a), 0.4 + uv.y());
  });
  const fabric::Material material;
  const auto maps = compute_maps(tube, drape, testing::cylinder_body(0.1, 1.0, 100, 20), {"shear"},
                                 {.material = &material});
  ASSERT_EQ(maps.size(), 1u);
  EXPECT_EQ(maps[0].array, "shear_angle_deg");
  for (double angle : maps[0].values) EXPECT_NEAR(angle, degrees(std::atan(gamma)), 0.05);
}

}  // namespace
}  // namespace loosefit::maps
