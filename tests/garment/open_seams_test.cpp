#include "loosefit/garment/open_seams.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "loosefit/garment/assemble.h"
#include "support/simple_patterns.h"

namespace loosefit::garment {
namespace {

using namespace testing_support;

TEST(OpenSeams, PanelsHaveVerticesOfTheirOwnAndPartnersMeetInTheSewnGarment) {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("front", 0.4, 0.3), rectangle_panel("back", 0.4, 0.3)};
  pattern.stitches = {stitch(0, 1, 1, 3), stitch(0, 3, 1, 1)};
  const Garment sewn = assemble(pattern, 0.05, fabric::Material{});
  const OpenSeams open = open_seams(sewn);
  const auto& sides = *sewn.find_chain("front", "edge_1");
  EXPECT_EQ(open.garment.vertex_count, sewn.vertex_count + 2 * int(sides.vertices.size()));
  EXPECT_EQ(open.partners.size(), 2 * sides.vertices.size());
  for (const std::vector<int>& of : open.partners) {
    ASSERT_EQ(of.size(), 2u);
    EXPECT_EQ(open.sewn[of[0]], open.sewn[of[1]]);
    EXPECT_NE(open.garment.vertex_panel[of[0]], open.garment.vertex_panel[of[1]]);
  }
  double mass = 0;
  for (double m : open.garment.vertex_mass) mass += m;
  EXPECT_NEAR(mass, sewn.mass, 1e-12);
  for (std::size_t t = 0; t < sewn.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int v = open.garment.triangles[t][k];
      EXPECT_EQ(open.sewn[v], sewn.triangles[t][k]);
      EXPECT_EQ(open.garment.vertex_uv[v], sewn.triangle_uv[t][k]);
      EXPECT_EQ(open.garment.vertex_panel[v], sewn.triangle_panel[t]);
    }
}

TEST(OpenSeams, BothSidesOfATubeOfOnePieceAreToldApart) {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("tube", 0.4, 0.3)};
  pattern.stitches = {stitch(0, 1, 0, 3)};
  const Garment sewn = assemble(pattern, 0.05, fabric::Material{});
  const OpenSeams open = open_seams(sewn);
  EXPECT_EQ(open.garment.vertex_count, sewn.vertex_count + int(open.partners.size()));
  for (const std::vector<int>& of : open.partners)
    EXPECT_NEAR((open.garment.vertex_uv[of[0]] - open.garment.vertex_uv[of[1]]).norm(), 0.4, 1e-12);
}

}  // namespace
}  // namespace loosefit::garment
