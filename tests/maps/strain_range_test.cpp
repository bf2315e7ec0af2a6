#include "loosefit/maps/strain_range.h"

#include <gtest/gtest.h>

#include <tuple>

#include "support/wall_and_patch.h"

namespace loosefit::maps {
namespace {

/// The patch deformed by x = F (u, v) on its whole, on the half u > 0 by `half`.
std::vector<Vec3> stretched(const garment::Garment& patch, const Mat2& f, const Mat2& half) {
  std::vector<Vec3> x;
  for (const Vec2& uv : patch.vertex_uv) {
    const Vec2 p = uv.x() > 1e-9 ? Vec2(half * uv) : Vec2(f * uv);
    x.emplace_back(p.x(), p.y(), 0);
  }
  return x;
}

fabric::Material knit() {
  fabric::Material m;
  m.valid_strain_warp = 0.2;
  m.valid_strain_weft = 0.3;
  m.valid_shear = radians(10);
  return m;
}

TEST(StrainRange, WithinIsWithinAndTellsTheLargest) {
  const garment::Garment patch = testing::patch_garment(0.1, 0.01);
  Mat2 f;
  f << 1.25, 0, 0, 1.15;  // weft 25 %, warp 15 %
  const StrainRange range = strain_range(patch, stretched(patch, f, f), knit());
  EXPECT_NEAR(range.weft.largest, 0.25, 1e-12);
  EXPECT_NEAR(range.warp.largest, 0.15, 1e-12);
  EXPECT_EQ(range.share_beyond, 0);
}

TEST(StrainRange, HalfOfThePatchBeyondIsHalfOfItsArea) {
  const garment::Garment patch = testing::patch_garment(0.1, 0.01);
  Mat2 half;
  half << 1.5, 0, 0, 1;  // the weft 50 % on u > 0
  const StrainRange range = strain_range(patch, stretched(patch, Mat2::Identity(), half), knit());
  EXPECT_NEAR(range.weft.largest, 0.5, 1e-9);
  EXPECT_NEAR(range.weft.share_beyond, 0.5, 0.06);
  EXPECT_EQ(range.warp.share_beyond, 0);
  EXPECT_EQ(range.share_beyond, range.weft.share_beyond);
}

TEST(StrainRange, FarBeyondIsThreeTimesTheLimitOfAYarn) {
  const garment::Garment patch = testing::patch_garment(0.1, 0.01);
  for (const auto& [warp, weft, share] :
       {std::tuple{0.59, 0.0, 0.0}, {0.61, 0.0, 1.0}, {0.0, 0.89, 0.0}, {0.0, 0.91, 1.0}}) {
    Mat2 f;
    f << 1 + weft, 0, 0, 1 + warp;
    const StrainRange range = strain_range(patch, stretched(patch, f, f), knit());
    EXPECT_NEAR(range.share_far_beyond, share, 1e-12) << warp << " " << weft;
  }
  // Of what a card does not state nothing is known.
  Mat2 f;
  f << 3, 0, 0, 3;
  EXPECT_EQ(strain_range(patch, stretched(patch, f, f), fabric::Material{}).share_far_beyond, 0);
}

TEST(StrainRange, ShearIsTheAngleOfEitherSign) {
  const garment::Garment patch = testing::patch_garment(0.1, 0.01);
  for (const double gamma : {0.25, -0.25}) {
    Mat2 f;
    f << 1, gamma, 0, 1;
    const StrainRange range = strain_range(patch, stretched(patch, f, f), knit());
    EXPECT_NEAR(range.shear.largest, std::atan(0.25), 1e-12);
    EXPECT_NEAR(range.shear.share_beyond, 1, 1e-12);
    EXPECT_NEAR(range.share_beyond, 1, 1e-12);
  }
}

TEST(StrainRange, CompressionHasNoLimitAndWhatIsNotStatedIsNotBeyond) {
  const garment::Garment patch = testing::patch_garment(0.1, 0.01);
  EXPECT_EQ(
      strain_range(patch, stretched(patch, 0.5 * Mat2::Identity(), 0.5 * Mat2::Identity()), knit())
          .share_beyond,
      0);
  const StrainRange unknown =
      strain_range(patch, stretched(patch, 2 * Mat2::Identity(), 2 * Mat2::Identity()), {});
  EXPECT_NEAR(unknown.warp.largest, 1, 1e-12);
  EXPECT_EQ(unknown.share_beyond, 0);
  EXPECT_FALSE(unknown.warp.is_stated());
}

}  // namespace
}  // namespace loosefit::maps
