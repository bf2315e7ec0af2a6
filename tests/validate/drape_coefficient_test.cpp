#include "loosefit/validate/drape_coefficient.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/validate/drape_specimen.h"

namespace loosefit::validate {
namespace {

const DrapeTester kTester;

/// Shadow areas of the flat specimen and of its part on the disc, and of a deformed one.
struct Shadows {
  Specimen specimen = cut_drape_specimen(kTester, 0.008, fabric::Material{});
  double coefficient(const std::function<Vec3(const Vec2&)>& place) const {
    particles::VectorField flat, x;
    for (const Vec2& p : specimen.vertex_uv)
      flat.emplace_back(p[0], p[1], 0), x.push_back(place(p));
    std::vector<Triangle> carried;
    for (std::size_t i = 0; i < specimen.triangles.size(); ++i)
      if (specimen.triangle_panel[i] == 0) carried.push_back(specimen.triangles[i]);
    return drape_coefficient(shadow_area(x, specimen.triangles), shadow_area(flat, carried),
                             shadow_area(flat, specimen.triangles));
  }
};

Vec3 on_cone(const Vec2& p, double slope) {
  const double r = p.norm(), a = kTester.disc_radius, beyond = std::max(0.0, r - a);
  const double share = r > 0 ? (std::min(r, a) + beyond * std::cos(slope)) / r : 1;
  return {share * p[0], share * p[1], -beyond * std::sin(slope)};
}

TEST(DrapeCoefficient, ofAFlatDiscIsOne) {
  EXPECT_NEAR(Shadows().coefficient([](const Vec2& p) { return Vec3(p[0], p[1], 0.02); }), 1,
              1e-12);
}

TEST(DrapeCoefficient, ofAConeIsThatOfItsRing) {
  const double a = kTester.disc_radius, b = kTester.specimen_radius;
  for (double slope : {0.3, 1.0, 1.4}) {
    const double rim = a + (b - a) * std::cos(slope);
    const double expected = (rim * rim - a * a) / (b * b - a * a);
    EXPECT_NEAR(Shadows().coefficient([&](const Vec2& p) { return on_cone(p, slope); }), expected,
                2e-3)
        << slope;
  }
}

TEST(DrapeCoefficient, ofClothHangingStraightDownIsZero) {
  EXPECT_NEAR(Shadows().coefficient([](const Vec2& p) { return on_cone(p, kPi / 2); }), 0, 1e-3);
}

TEST(DrapeCoefficient, countsClothFoldedOverItselfOnce) {
  // The ring beyond 12 cm folded back inwards: the shadow ends at 12 cm.
  const double fold = 0.12, a = kTester.disc_radius, b = kTester.specimen_radius;
  const double dc = Shadows().coefficient([&](const Vec2& p) -> Vec3 {
    const double r = p.norm();
    if (r <= fold) return {p[0], p[1], 0};
    return {p[0] * (2 * fold - r) / r, p[1] * (2 * fold - r) / r, -0.001};
  });
  // A triangle across the fold line may fall short of it by up to its height.
  const double ideal = (fold * fold - a * a) / (b * b - a * a);
  EXPECT_LT(dc, ideal + 1e-3);
  EXPECT_GT(dc, ideal - 0.08);
}

TEST(DrapeCoefficient, refusesADiscLargerThanTheCloth) {
  EXPECT_THROW(drape_coefficient(1, 2, 1), InvalidInput);
}

TEST(ShadowArea, isExactForATurnedSquareAndForOverlaps) {
  particles::VectorField x;
  const auto square = [&](double angle, double size, double z) {
    const double c = std::cos(angle) * size / 2, s = std::sin(angle) * size / 2;
    const int first = static_cast<int>(x.size());
    for (const auto& [u, v] :
         {std::pair{1, 1}, std::pair{-1, 1}, std::pair{-1, -1}, std::pair{1, -1}})
      x.emplace_back(u * c - v * s, u * s + v * c, z * u);
    return std::vector<Triangle>{{first, first + 1, first + 2}, {first, first + 2, first + 3}};
  };
  std::vector<Triangle> triangles = square(0.3, 0.2, 0.05);
  EXPECT_NEAR(shadow_area(x, triangles), 0.04, 6.25e-8);
  for (const Triangle& t : square(0.3, 0.1, 0.01)) triangles.push_back(t);
  EXPECT_NEAR(shadow_area(x, triangles), 0.04, 6.25e-8) << "the smaller square lies in the shadow";
}

TEST(ShadowArea, convergesToTheCircle) {
  particles::VectorField x{Vec3::Zero()};
  std::vector<Triangle> fan;
  constexpr int kSides = 720;
  for (int i = 0; i < kSides; ++i) {
    const double t = 2 * kPi * i / kSides;
    x.emplace_back(0.1 * std::cos(t), 0.1 * std::sin(t), 0);
    fan.push_back({0, 1 + i, 1 + (i + 1) % kSides});
  }
  const double polygon = 0.5 * kSides * 0.01 * std::sin(2 * kPi / kSides);
  EXPECT_NEAR(shadow_area(x, fan, 1e-3) / polygon, 1, 4e-4);
  EXPECT_NEAR(shadow_area(x, fan, 1e-4) / polygon, 1, 2e-5);
}

TEST(CountFolds, findsTheHarmonicAndItsAmplitude) {
  std::vector<Vec3> rim;
  std::vector<double> angle;
  for (int i = 0; i < 113; ++i) {
    angle.push_back(-kPi + 2 * kPi * i / 113.0);
    const double r =
        0.12 + 0.01 * std::cos(6 * angle.back() + 0.4) + 0.002 * std::sin(angle.back());
    rim.emplace_back(r * std::cos(angle.back()), r * std::sin(angle.back()), -0.05);
  }
  const Folds folds = count_folds(rim, angle);
  EXPECT_EQ(folds.count, 6);
  EXPECT_NEAR(folds.amplitude, 0.01, 1e-5);
  EXPECT_NEAR(folds.share, 1 / 1.04, 1e-4);
}

TEST(DrapeSpecimen, hasTheDiscsRimAmongItsVertices) {
  const Specimen s = cut_drape_specimen(kTester, 0.008, fabric::Material{});
  int on_rim = 0;
  for (const Vec2& p : s.vertex_uv) on_rim += std::abs(p.norm() - kTester.disc_radius) < 1e-9;
  EXPECT_GE(on_rim, 2 * kPi * kTester.disc_radius / 0.008 - 1);
  EXPECT_NEAR(s.area, kPi * std::pow(kTester.specimen_radius, 2), 1e-3 * s.area);
  EXPECT_LT(on_disc(s, kTester).size(), s.vertex_uv.size() / 2);
}

}  // namespace
}  // namespace loosefit::validate
