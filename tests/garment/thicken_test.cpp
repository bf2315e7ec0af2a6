#include "loosefit/garment/thicken.h"

#include <gtest/gtest.h>

#include <numeric>

#include "loosefit/garment/assemble.h"
#include "loosefit/geometry/flat_triangle.h"
#include "support/simple_patterns.h"

namespace loosefit::garment {
namespace {

fabric::Material cloth() {
  fabric::Material m;
  m.areal_density = 0.2;
  m.bending_warp = 4e-6;
  m.bending_weft = 9e-6;
  return m;
}

/// ∫ value dA over the flat pieces.
double integral(const Garment& g, const std::vector<double>& value) {
  double sum = 0;
  for (std::size_t t = 0; t < g.triangles.size(); ++t)
    sum += value[t] * geometry::flat_area(g.triangle_uv[t]);
  return sum;
}

double total(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(Thicken, PiecesAreAsHeavyAndStiffAsTheirPatternSays) {
  pattern::Pattern square;
  square.panels = {testing_support::rectangle_panel("strip", .3, .04)};
  square.panels[0].cloth = {2, 0.7, 3};
  const Garment g = assemble(square, .02, cloth());
  EXPECT_NEAR(g.mass, 2 * .2 * .3 * .04, 1e-12);
  EXPECT_NEAR(total(g.vertex_mass), g.mass, 1e-12);
  for (std::size_t t = 0; t < g.triangles.size(); ++t) {
    EXPECT_NEAR(g.triangle_membrane_factor[t], 0.7, 1e-12);
    EXPECT_NEAR(g.triangle_added_bending[t], 2 * 6e-6, 1e-18);
  }
}

TEST(Thicken, HemsAddASecondLayerAlongTheirEdgeOnly) {
  for (const double edge : {.004, .02}) {
    pattern::Pattern square;
    square.panels = {testing_support::rectangle_panel("piece", .3, .2)};
    square.panels[0].edges[0].finish = 0.01;
    const Garment g = assemble(square, edge, cloth());
    const double hem = .3 * 0.01;
    EXPECT_NEAR(g.mass, .2 * (.3 * .2 + hem), 0.06 * .2 * hem) << edge;
    EXPECT_NEAR(total(g.vertex_mass), g.mass, 1e-12);
    EXPECT_NEAR(integral(g, g.triangle_membrane_factor), .3 * .2 + hem, 0.06 * hem);
    EXPECT_NEAR(integral(g, g.triangle_added_bending), (kHemBending - 1) * 6e-6 * hem,
                0.06 * (kHemBending - 1) * 6e-6 * hem);
    for (std::size_t t = 0; t < g.triangles.size(); ++t) {
      double lowest = 1;
      for (const Vec2& p : g.triangle_uv[t]) lowest = std::min(lowest, p.y());
      if (lowest > 0.01) {
        EXPECT_EQ(g.triangle_membrane_factor[t], 1);
        EXPECT_EQ(g.triangle_added_bending[t], 0);
      }
    }
  }
}

}  // namespace
}  // namespace loosefit::garment
