#include "loosefit/maps/strain_range.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "loosefit/drape/rims.h"
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

TEST(StrainRange, CrushedAndTornTrianglesAreCountedAsTheyAre) {
  const garment::Garment patch = testing::patch_garment(0.1, 0.01);
  std::size_t right = 0;  // triangles of which no corner is on the left half
  for (const auto& uv : patch.triangle_uv)
    right += std::all_of(uv.begin(), uv.end(), [](const Vec2& p) { return p.x() > 1e-9; });
  for (const double weft : {0.3, 0.45, 0.55, 0.9, 1.2, 1.5, 2.5}) {
    Mat2 half;
    half << weft, 0, 0, 1;
    const std::vector<Vec3> x = stretched(patch, Mat2::Identity(), half);
    const StrainRange range = strain_range(patch, x, knit());
    EXPECT_GE(range.crushed.size(), weft < 0.5 ? right : 0) << weft;
    EXPECT_EQ(range.crushed.empty(), weft > 0.5) << weft;
    EXPECT_GE(range.torn.size(), weft > 1.35 ? right : 0) << weft;
    EXPECT_EQ(range.torn.empty(), weft < 1.3) << weft;
    // Triangles across the middle are sheared, which stretches their warp a little.
    EXPECT_NEAR(range.least, std::min(0.0, weft - 1), 1e-9);
    EXPECT_NEAR(range.most, std::max(0.0, weft - 1), weft < 1 ? 0.05 : 1e-9);
  }
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

/// The patch on a wall whose skin is of one region, strained as a whole.
std::vector<TornRegion> torn(const garment::Garment& patch, double warp, double weft,
                             const fabric::Material& material, double share = 1) {
  Mat2 f;
  f << 1 + weft, 0, 0, 1 + warp;
  std::vector<Vec3> x;
  double begin = HUGE_VAL, end = -HUGE_VAL;
  for (const Vec2& uv : patch.vertex_uv) {
    begin = std::min(begin, uv.x());
    end = std::max(end, uv.x());
  }
  // Strained along the weft up to this share of its width, as cut beyond.
  const double edge = begin + share * (end - begin);
  for (const Vec2& uv : patch.vertex_uv) {
    const double u = (1 + weft) * std::min(uv.x(), edge) + std::max(0.0, uv.x() - edge);
    x.emplace_back(-u, 0.001, (1 + warp) * uv.y());
  }
  body::Body wall = testing::wall_body();
  wall.segment.clear();  // a body without segments is one region
  return torn_regions(patch, x, material, wall);
}

TEST(TornRegions, AreStrainedBeyondAnyWovenAndBeyondTheStretchOfAKnit) {
  const garment::Garment patch = testing::patch_garment(0.1, 0.01);
  fabric::Material stretchy = knit();
  stretchy.stretch_weft = 1;
  for (const auto& [warp, weft, of_knit, of_stretchy] : {std::tuple{0.34, 0.0, false, false},
                                                         {0.36, 0.0, true, true},
                                                         {0.0, 0.34, false, false},
                                                         {0.0, 0.36, true, false},
                                                         {0.0, 0.99, true, false},
                                                         {0.0, 1.01, true, true}}) {
    EXPECT_EQ(torn(patch, warp, weft, knit()).size(), of_knit ? 1u : 0u) << warp << " " << weft;
    EXPECT_EQ(torn(patch, warp, weft, stretchy).size(), of_stretchy ? 1u : 0u)
        << warp << " " << weft;
  }
  // A short curve is where a test ended, a long one where cloth was seen whole.
  fabric::Material measured = knit();
  for (const double end : {0.014, 0.085, 0.34}) {
    measured.valid_strain_warp = end;
    EXPECT_TRUE(torn(patch, 0.34, 0, measured).empty()) << end;
    EXPECT_EQ(torn(patch, 0.36, 0, measured).size(), 1u) << end;
  }
  measured.valid_strain_warp = 0.8;
  EXPECT_TRUE(torn(patch, 0.79, 0, measured).empty());
  EXPECT_EQ(torn(patch, 0.81, 0, measured).size(), 1u);
  // Of what a card does not state nothing is known.
  EXPECT_TRUE(torn(patch, 3, 3, {}).empty());
}

TEST(TornRegions, TakeHalfOfTheClothOfARegionAndMoreThanAFewTriangles) {
  const garment::Garment patch = testing::patch_garment(0.1, 0.01),
                         small = testing::patch_garment(0.04, 0.01);
  EXPECT_TRUE(torn(patch, 0, 0.7, knit(), 0.4).empty());
  const auto most = torn(patch, 0, 0.7, knit(), 0.7);
  ASSERT_EQ(most.size(), 1u);
  EXPECT_NEAR(most[0].share, 0.7, 0.1);
  EXPECT_FALSE(most[0].is_warp);
  EXPECT_NEAR(most[0].largest, 0.7, 1e-9);
  EXPECT_NEAR(most[0].limit, drape::kTears, 1e-12);
  EXPECT_TRUE(torn(small, 0, 0.7, knit()).empty()) << "16 cm²";
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
