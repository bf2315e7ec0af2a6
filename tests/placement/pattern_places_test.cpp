#include "loosefit/placement/pattern_places.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "support/tube_garment.h"

namespace loosefit::placement {
namespace {

constexpr double kWidth = 0.6, kHeight = 0.4;

TEST(PatternLocator, FindsTheTriangleAndItsWeights) {
  const garment::Garment tube = testing::tube_garment(kWidth, kHeight, 30, 20);
  const PatternLocator locator(tube);
  for (const Vec2& at : {Vec2(0.123, 0.234), Vec2(0, 0), Vec2(kWidth, kHeight), Vec2(0.3, 0.2)}) {
    const auto place = locator.find(0, at);
    ASSERT_TRUE(place.has_value()) << at.transpose();
    Vec2 back = Vec2::Zero();
    for (int k = 0; k < 3; ++k)
      back += place->barycentric[k] * tube.triangle_uv[place->triangle][k];
    EXPECT_NEAR((back - at).norm(), 0, 1e-12);
    EXPECT_NEAR(place->barycentric.sum(), 1, 1e-12);
    EXPECT_GE(place->barycentric.minCoeff(), -1e-9);
  }
  EXPECT_FALSE(locator.find(0, {-0.001, 0.2}).has_value());
  EXPECT_FALSE(locator.find(0, {0.3, kHeight + 0.001}).has_value());
  EXPECT_FALSE(locator.find(1, {0.3, 0.2}).has_value());
}

TEST(PoissonPlaces, KeepTheirDistanceAndLeaveNoHole) {
  const garment::Garment tube = testing::tube_garment(kWidth, kHeight, 30, 20);
  const PatternLocator locator(tube);
  const double spacing = 0.02;
  const auto places = poisson_places(locator, spacing);
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      ASSERT_GE((places[i].at - places[j].at).norm(), spacing - 1e-12);
  // Hexagonal packing at this distance is the most, covering circles of 1.09 spacings the least.
  EXPECT_LT(places.size(), kWidth * kHeight / (std::sqrt(0.75) * spacing * spacing) + 100);
  for (double u = 0; u <= kWidth; u += 0.007)
    for (double v = 0; v <= kHeight; v += 0.007) {
      double nearest = 1;
      for (const PatternPlace& p : places) nearest = std::min(nearest, (p.at - Vec2(u, v)).norm());
      ASSERT_LE(nearest, 1.09 * spacing) << u << " " << v;
    }
}

TEST(PoissonPlaces, AreFixedBySeed) {
  const garment::Garment tube = testing::tube_garment(kWidth, kHeight, 30, 20);
  const PatternLocator locator(tube);
  const auto a = poisson_places(locator, 0.05, 1), b = poisson_places(locator, 0.05, 1);
  const auto c = poisson_places(locator, 0.05, 2);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].at, b[i].at);
  EXPECT_NE(a[0].at, c[0].at);
  EXPECT_THROW(poisson_places(locator, 0), InvalidInput);
  EXPECT_THROW(poisson_places(locator, std::nan("")), InvalidInput);
}

// The tube is one panel sewn to itself at u = 0 and u = width; v = 0 and v = height are hems.
TEST(PanelBorders, TellSeamsFromFreeEdges) {
  const PanelBorders borders(testing::tube_garment(kWidth, kHeight, 30, 20));
  EXPECT_NEAR(borders.to_seam(0, {0.05, 0.2}), 0.05, 1e-12);
  EXPECT_NEAR(borders.to_seam(0, {0.57, 0.2}), 0.03, 1e-12);
  EXPECT_NEAR(borders.to_free_edge(0, {0.05, 0.17}), 0.17, 1e-12);
  EXPECT_NEAR(borders.to_free_edge(0, {0.3, 0.39}), 0.01, 1e-12);
}

TEST(PanelBorders, PanelWithoutSeamsHasNone) {
  garment::Garment sheet = testing::tube_garment(kWidth, kHeight, 30, 20);
  // Unwelded: the last column gets vertices of its own.
  for (std::size_t t = 0; t < sheet.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (sheet.triangle_uv[t][k].x() > kWidth - 1e-9) sheet.triangles[t][k] += 1000;
  const PanelBorders borders(sheet);
  EXPECT_EQ(borders.to_seam(0, {0.3, 0.2}), std::numeric_limits<double>::infinity());
  EXPECT_NEAR(borders.to_free_edge(0, {0.05, 0.2}), 0.05, 1e-12);
}

}  // namespace
}  // namespace loosefit::placement
