#include "loosefit/maps/section_gap.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "loosefit/base/error.h"
#include "support/tube_garment.h"

namespace loosefit::maps {
namespace {

std::vector<Vec2> ellipse(double a, double b, Vec2 centre = {0, 0}, int corners = 2000) {
  std::vector<Vec2> points;
  for (int i = 0; i < corners; ++i) {
    const double t = 2 * kPi * i / corners;
    points.emplace_back(centre.x() + a * std::cos(t), centre.y() + b * std::sin(t));
  }
  return points;
}

double ellipse_girth(double a, double b) {  // of Ramanujan, here within 1e-9
  const double h = std::pow((a - b) / (a + b), 2);
  return kPi * (a + b) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
}

TEST(SectionGap, RoundTubeRoundAnEllipseHasAreaGirthAndFullFilling) {
  const double a = 0.15, b = 0.11, r = 0.16;
  const SectionGap s = section_gap(ellipse(a, b), ellipse(r, r), {0, 0});
  EXPECT_NEAR(s.body_area, kPi * a * b, 1e-6);
  EXPECT_NEAR(s.body_girth, ellipse_girth(a, b), 1e-5);
  EXPECT_NEAR(s.gap_area(), kPi * (r * r - a * b), 1e-6);
  EXPECT_NEAR(s.mean_gap(), kPi * (r * r - a * b) / ellipse_girth(a, b), 1e-6);
  EXPECT_NEAR(s.filling(), 1, 1e-4);
  EXPECT_NEAR(s.cloth_width / s.body_width, r / a, 1e-5);
  EXPECT_NEAR(s.cloth_depth / s.body_depth, r / b, 1e-5);
}

// docs/theory/air_gap.md 2: the mean radial gap of a tube is its ease over 2π, and what the body
// lacks to a circle; 2.7 to 3.7 mm for sections of trunks.
TEST(SectionGap, MeanRayIsEaseOverTwoPiAndTheBodysWantOfRoundness) {
  for (const Vec2& half :
       {Vec2(0.150, 0.110), Vec2(0.160, 0.115), Vec2(0.140, 0.100), Vec2(0.170, 0.130)}) {
    const double girth = ellipse_girth(half.x(), half.y()), ease = 0.24;
    const double r = (girth + ease) / (2 * kPi);
    const SectionGap s = section_gap(ellipse(half.x(), half.y()), ellipse(r, r), {0, 0}, 720);
    const double mean = std::accumulate(s.gap.begin(), s.gap.end(), 0.0) / s.gap.size();
    const double want = mean - ease / (2 * kPi);
    EXPECT_GT(want, 2.6e-3);
    EXPECT_LT(want, 3.8e-3);
  }
}

TEST(SectionGap, HangingOnTheBackPutsTwiceTheRingInFront) {
  const double r = 0.13, cloth = 0.15;
  const SectionGap s = section_gap(ellipse(r, r), ellipse(cloth, cloth, {0, r - cloth}), {0, 0}, 4);
  EXPECT_NEAR(s.gap[1], 0, 1e-5);                // back
  EXPECT_NEAR(s.gap[3], 2 * (cloth - r), 1e-5);  // front
  EXPECT_NEAR(s.gap_area(), kPi * (cloth * cloth - r * r), 1e-6) << "as of a tube in the middle";
  EXPECT_GT(s.quadrant[3], 5 * s.quadrant[1]);
}

TEST(SectionGap, QuadrantsSumToTheWholeAndAreThoseOfTheSectors) {
  const double a = 0.16, b = 0.12, r = 0.17;
  const SectionGap s = section_gap(ellipse(a, b), ellipse(r, r), {0, 0});
  EXPECT_NEAR(std::accumulate(s.quadrant.begin(), s.quadrant.end(), 0.0), s.gap_area(), 1e-12);
  // Area of an ellipse within 45° of its long axis: a b atan(a/b).
  EXPECT_NEAR(s.quadrant[0], kPi * r * r / 4 - a * b * std::atan(a / b), 1e-6);
  EXPECT_NEAR(s.quadrant[1], kPi * r * r / 4 - a * b * std::atan(b / a), 1e-6);
  EXPECT_NEAR(s.quadrant[0], s.quadrant[2], 1e-9);
}

TEST(SectionGap, FoldsTakeClothButHardlyAir) {
  std::vector<Vec2> folded;
  for (int i = 0; i < 4000; ++i) {
    const double t = 2 * kPi * i / 4000, r = 0.15 * (1 + 0.05 * std::cos(12 * t));
    folded.emplace_back(r * std::cos(t), r * std::sin(t));
  }
  const SectionGap s = section_gap(ellipse(0.13, 0.13), folded, {0, 0});
  EXPECT_NEAR(s.gap_area(), kPi * (0.15 * 0.15 * (1 + 0.5 * 0.05 * 0.05) - 0.13 * 0.13), 1e-5);
  EXPECT_GT(s.filling(), 0.5);
  EXPECT_LT(s.filling(), 0.85);
  std::reverse(folded.begin(), folded.end());
  EXPECT_DOUBLE_EQ(section_gap(ellipse(0.13, 0.13), folded, {0, 0}).gap_area(), s.gap_area())
      << "the turn of an outline means nothing";
}

TEST(SectionGap, OutlinesThatDoNotGoRoundTheMiddleAreRefused) {
  EXPECT_THROW(section_gap(ellipse(0.1, 0.1), ellipse(0.1, 0.1), {0.3, 0}), InvalidInput);
  EXPECT_THROW(section_gap({{0, 0}, {1, 0}}, ellipse(0.1, 0.1), {0, 0}), InvalidInput);
}

TEST(TrunkSection, CutsBodyAndCloth) {
  const body::Body body = testing::cylinder_body(0.12, 1.0, 400, 20);
  const garment::Garment g = testing::tube_garment(2 * kPi * 0.15, 0.4, 400, 20);
  const drape::Drape d = testing::settled_drape(g, [](const Vec2& uv) {
    const double a = uv.x() / 0.15;
    return Vec3(0.15 * std::cos(a), 0.02 + 0.15 * std::sin(a), 0.3 + uv.y());
  });
  const WornGarment worn = relate(g, d.positions, body);
  const auto section = trunk_section(g, d.positions, worn, body, 0.513);
  ASSERT_TRUE(section);
  EXPECT_NEAR(section->gap_area(), kPi * (0.15 * 0.15 - 0.12 * 0.12), 5e-6);
  EXPECT_NEAR(section->filling(), 1, 2e-3);
  EXPECT_FALSE(trunk_section(g, d.positions, worn, body, 0.2)) << "below the hem";
}

/// A tube whose wall is cut away above a height over the angles from `from` to `to`, as by
/// armholes.
garment::Garment cut_tube(const garment::Garment& tube, double radius, double height,
                          const std::vector<std::array<double, 2>>& openings) {
  garment::Garment cut = tube;
  cut.triangles.clear(), cut.triangle_uv.clear(), cut.triangle_panel.clear();
  for (std::size_t t = 0; t < tube.triangles.size(); ++t) {
    Vec2 middle = Vec2::Zero();
    for (int v : tube.triangles[t]) middle += tube.vertex_uv[v] / 3;
    bool open = false;
    for (const auto& [from, to] : openings)
      open |= middle.y() > height && middle.x() / radius > from && middle.x() / radius < to;
    if (open) continue;
    cut.triangles.push_back(tube.triangles[t]);
    cut.triangle_uv.push_back(tube.triangle_uv[t]);
    cut.triangle_panel.push_back(tube.triangle_panel[t]);
  }
  return cut;
}

// Sectors of ring are left: radial edges, along the skin between them.
TEST(TrunkSection, ArmholesAreClosedAlongTheSkin) {
  const double r = 0.12, big = 0.15, level = 0.513;
  const body::Body body = testing::cylinder_body(r, 1.0, 400, 20);
  const garment::Garment tube = testing::tube_garment(2 * kPi * big, 0.4, 400, 20);
  const drape::Drape d = testing::settled_drape(tube, [&](const Vec2& uv) {
    const double a = uv.x() / big;
    return Vec3(big * std::cos(a), big * std::sin(a), 0.3 + uv.y());
  });
  for (const auto& openings :
       {std::vector<std::array<double, 2>>{{kPi - 0.2, kPi + 0.3}},
        std::vector<std::array<double, 2>>{{0.9, 1.4}, {kPi - 0.2, kPi + 0.3}}}) {
    const garment::Garment g = cut_tube(tube, big, 0.15, openings);
    const WornGarment worn = relate(g, d.positions, body);
    EXPECT_FALSE(trunk_section(g, d.positions, worn, body, level)) << "open";
    EXPECT_TRUE(trunk_section(g, d.positions, worn, body, 0.4)) << "below the armholes";
    const auto section = trunk_section(g, d.positions, worn, body, level, 0.1);
    ASSERT_TRUE(section);
    const double bare = 0.5 * static_cast<double>(openings.size()), grid = 2 * kPi / 400;
    EXPECT_NEAR(section->opened, bare * r, 3 * grid * r);
    EXPECT_NEAR(section->gap_area(), (kPi - 0.5 * bare) * (big * big - r * r), 1e-4);
    EXPECT_NEAR(section->cloth_girth,
                (2 * kPi - bare) * big + bare * r + 2 * openings.size() * 0.03, 2e-3);
    EXPECT_NEAR(section->gap[36], 0, 1e-5) << "bare skin at 180°";
    EXPECT_NEAR(section->gap[54], big - r, 1e-4) << "cloth at 270°";
    EXPECT_FALSE(trunk_section(g, d.positions, worn, body, level, 0.055)) << "too wide for that";
  }
}

// The skin's outline begins within the opening: at the angle 0.
TEST(TrunkSection, AnOpeningMayLieAcrossTheFirstCornerOfTheSkin) {
  const double r = 0.12, big = 0.15, level = 0.513;
  const body::Body body = testing::cylinder_body(r, 1.0, 400, 20);
  const garment::Garment tube = testing::tube_garment(2 * kPi * big, 0.4, 400, 20);
  for (double turned : {0.0, 0.1, 3.0}) {  // of the tube on the skin
    const drape::Drape d = testing::settled_drape(tube, [&](const Vec2& uv) {
      const double a = uv.x() / big + turned;
      return Vec3(big * std::cos(a), big * std::sin(a), 0.3 + uv.y());
    });
    const garment::Garment g = cut_tube(tube, big, 0.15, {{-1, 0.3}, {2 * kPi - 0.2, 7}});
    const auto section =
        trunk_section(g, d.positions, relate(g, d.positions, body), body, level, 0.1);
    ASSERT_TRUE(section) << turned;
    EXPECT_NEAR(section->opened, 0.5 * r, 3 * 2 * kPi / 400 * r) << turned;
    EXPECT_NEAR(section->gap_area(), (kPi - 0.25) * (big * big - r * r), 1e-4) << turned;
  }
}

}  // namespace
}  // namespace loosefit::maps
