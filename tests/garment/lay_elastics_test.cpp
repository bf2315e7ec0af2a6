#include "loosefit/garment/lay_elastics.h"

#include <gtest/gtest.h>

#include "loosefit/garment/hierarchy.h"
#include "loosefit/pattern/outline.h"
#include "support/simple_patterns.h"

namespace loosefit::garment {
namespace {

using namespace testing_support;

constexpr pattern::EdgeElastic kTape{0.8, 25, 0.03};

double energy(const Garment& g, double along, double across) {
  std::vector<Vec3> x;
  for (const Vec2& uv : g.vertex_uv) x.emplace_back(along * uv.x(), across * uv.y(), 0);
  return fabric::BandEnergy(g.triangles, g.bands).value(x);
}

TEST(LayElastics, ATapePullsAsItsOwnLengthSaysOnEveryLevel) {
  pattern::Pattern square;
  square.panels = {rectangle_panel("front", .4, .3)};
  square.panels[0].edges[0].elastic = kTape;  // from (0, 0) to (0.4, 0)
  for (const Garment& g : build_hierarchy(square, .01, {}).levels) {
    double length = 0;
    for (const fabric::BandPart& part : g.bands) length += part.length;
    EXPECT_NEAR(length, 0.4, 1e-9);
    // Slack where the edge is gathered to the tape's own length, and however the cloth is
    // stretched square to it.
    EXPECT_NEAR(energy(g, 0.8, 1), 0, 1e-15);
    EXPECT_NEAR(energy(g, 0.8, 1.3), 0, 1e-15);
    const double flat = 25 * (0.8 * 0.4) * fabric::band_law(1 / 0.8 - 1).energy;
    EXPECT_NEAR(energy(g, 1, 1), flat, 1e-9 * flat);
    // Force at the flat length: EA e, less what the slack takes (band_law).
    const double force = (energy(g, 1 + 1e-6, 1) - energy(g, 1 - 1e-6, 1)) / (2e-6 * 0.4);
    EXPECT_NEAR(force, 25 * (0.25 - fabric::kBandSlackElongation / 2), 1e-6);
  }
}

TEST(LayElastics, TheWeightOfATapeIsOfItsOwnLengthAndCountsAsCloth) {
  pattern::Pattern square;
  square.panels = {rectangle_panel("front", .4, .3)};
  const Garment plain = build_hierarchy(square, .01, {}).finest();
  square.panels[0].edges[0].elastic = kTape;
  square.panels[0].edges[0].elastic->linear_density = 0.02;
  for (const Garment& g : build_hierarchy(square, .01, {}).levels) {
    double mass = 0, along_edge = 0;
    for (int v = 0; v < g.vertex_count; ++v) {
      mass += g.cloth_mass(v);
      if (g.vertex_uv[v].y() < 1e-9) along_edge += g.vertex_mass[v];
    }
    EXPECT_NEAR(mass, g.mass, 1e-12);
    EXPECT_NEAR(g.mass - plain.mass, 0.02 * 0.8 * 0.4, 1e-12);
    EXPECT_GT(along_edge, 0.02 * 0.8 * 0.4);
  }
}

TEST(LayElastics, ATapeLiesWithinItsWidthOfItsEdge) {
  pattern::Pattern square;
  square.panels = {rectangle_panel("front", .4, .3)};
  square.panels[0].edges[0].elastic = kTape;
  const Garment g = build_hierarchy(square, .01, {}).finest();
  double low = 1, high = 0;
  for (const fabric::BandPart& part : g.bands) {
    double share = 0;
    for (const fabric::BandTriangle& t : part.triangles) {
      share += t.share;
      for (const Vec2& corner : g.triangle_uv[t.triangle]) {
        low = std::min(low, corner.y());
        high = std::max(high, corner.y());
      }
    }
    EXPECT_NEAR(share, 1, 1e-12);
  }
  EXPECT_EQ(low, 0);
  EXPECT_GT(high, 0.03 - 1e-9);
  EXPECT_LT(high, 0.03 + 0.015);
}

TEST(LayElastics, AnEdgeWithoutOneHasNoBand) {
  pattern::Pattern square;
  square.panels = {rectangle_panel("front", .4, .3)};
  const Garment g = build_hierarchy(square, .02, {}).finest();
  EXPECT_TRUE(g.bands.empty());
}

}  // namespace
}  // namespace loosefit::garment
