#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/dress/dress.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/geometry/exact_intersection.h"
#include "support/simple_patterns.h"

namespace loosefit {
namespace {

using namespace testing_support;

/// Two squares sewn at both sides into a tube: the front before, the back behind and turned round.
Pattern two_squares(double distance) {
  Pattern pattern;
  pattern.panels = {rectangle_panel("front", 0.4, 0.3), rectangle_panel("back", 0.4, 0.3)};
  // Outside (panel z) of the front looks to −y, of the back to +y.
  Mat3 front, back;
  front.col(0) = Vec3::UnitX();
  front.col(1) = Vec3::UnitZ();
  front.col(2) = -Vec3::UnitY();
  back.col(0) = -Vec3::UnitX();
  back.col(1) = Vec3::UnitZ();
  back.col(2) = Vec3::UnitY();
  pattern.panels[0].rotation = front;
  pattern.panels[0].translation = Vec3(-0.2, -distance / 2, 1.0);
  pattern.panels[1].rotation = back;
  pattern.panels[1].translation = Vec3(0.2, distance / 2, 1.0);
  pattern.stitches = {stitch(0, 1, 1, 3), stitch(0, 3, 1, 1)};
  return pattern;
}

TEST(DressAsPlaced, PutsPanelsWhereThePatternSaysAndClosesSeamsInTheMiddle) {
  const Pattern pattern = two_squares(0.3);
  const Garment g = assemble(pattern, 0.04, Material{});
  EXPECT_FALSE(is_shirt(g));
  const auto x = dress_as_placed(g, pattern);
  EXPECT_TRUE(self_intersections(x, g.triangles).empty());
  for (const auto& chain : g.edge_chains)
    for (int v : chain.vertices)
      if (chain.edge == 1 || chain.edge == 3) {
        EXPECT_NEAR(x[v][1], 0, 1e-12);
        EXPECT_NEAR(std::abs(x[v][0]), 0.2, 1e-12);
      }
  // Panel interiors keep their place and their outside.
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    const Triangle& tri = g.triangles[t];
    const bool front = g.panel_names[g.triangle_panel[t]] == "front";
    const Vec3 n = triangle_normal(x[tri[0]], x[tri[1]], x[tri[2]]);
    EXPECT_GT((front ? -1 : 1) * n[1], 0);
    for (int k = 0; k < 3; ++k) {
      const double u = g.triangle_uv[t][k][0];
      if (u < 1e-9 || u > 0.4 - 1e-9) continue;
      EXPECT_NEAR(x[tri[k]][1], front ? -0.15 : 0.15, 1e-12);
      EXPECT_NEAR(x[tri[k]][2], 1.0 + g.triangle_uv[t][k][1], 1e-12);
    }
  }
}

TEST(DressAsPlaced, PanelsThatCrossAreNamed) {
  Pattern pattern = two_squares(0.1);
  // The back leans through the front.
  pattern.panels[1].rotation =
      pattern.panels[1].rotation * Eigen::AngleAxisd(0.8, Vec3::UnitX()).toRotationMatrix();
  const Garment g = assemble(pattern, 0.04, Material{});
  std::string what;
  for (double sign : {1.0, -1.0}) {
    pattern.panels[1].translation[1] = sign * 0.05;
    try {
      dress_as_placed(g, pattern);
    } catch (const GeometryError& e) {
      what = e.what();
      EXPECT_FALSE(e.hint().empty());
    }
  }
  EXPECT_NE(what.find("front"), std::string::npos) << what;
  EXPECT_NE(what.find("back"), std::string::npos) << what;
}

TEST(DressAsPlaced, PanelMissingFromThePatternIsNamed) {
  Pattern pattern = two_squares(0.3);
  const Garment g = assemble(pattern, 0.04, Material{});
  pattern.panels[1].name = "other";
  try {
    dress_as_placed(g, pattern);
    FAIL() << "no error";
  } catch (const GeometryError& e) {
    EXPECT_NE(std::string(e.what()).find("back"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace loosefit
