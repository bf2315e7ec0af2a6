#include "loosefit/garment/lay_band.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/garment/attach.h"
#include "loosefit/garment/hierarchy.h"
#include "support/simple_patterns.h"

namespace loosefit::garment {
namespace {

using namespace testing_support;

Attachment elastic(std::vector<Vec2> path, double width) {
  Cable cable;
  cable.path = std::move(path);
  cable.width = width;
  cable.axial_stiffness = 30;
  cable.pre_stretch = 0.2;
  return {"elastic", "front", cable};
}

GarmentHierarchy square_with(const Attachment& attachment) {
  pattern::Pattern p;
  p.panels = {rectangle_panel("front", .4, .4)};
  return build_hierarchy(p, .01, {}, {attachment});
}

/// Energy of all bands where the flat cloth is moved by `place`.
double energy(const Garment& g, const std::function<Vec3(const Vec2&)>& place) {
  std::vector<Vec3> x;
  for (const Vec2& uv : g.vertex_uv) x.push_back(place(uv));
  return fabric::BandEnergy(g.triangles, g.bands).value(x);
}

TEST(LayBand, StoresTheEnergyOfABandOfItsLengthOnEveryLevelWhateverItsWidth) {
  for (const double width : {0.002, 0.01, 0.03})
    for (const Garment& g :
         square_with(elastic({{.05, .06}, {.28, .31}, {.33, .12}}, width)).levels) {
      const double length = std::hypot(.23, .25) + std::hypot(.05, .19);
      double laid = 0;
      for (const fabric::BandPart& part : g.bands) laid += part.length;
      EXPECT_NEAR(laid, length, 1e-9);
      // Stretched alike in all directions.
      const double expected = 30 * length / 1.2 * fabric::band_law(1.2 * 1.1 - 1).energy;
      EXPECT_NEAR(energy(g, [](const Vec2& p) { return Vec3(1.1 * p.x(), 1.1 * p.y(), 0); }),
                  expected, 1e-9 * expected);
    }
}

TEST(LayBand, FeelsTheStretchOfItsOwnDirection) {
  const Vec2 from(.08, .05), to(.30, .32);
  const Garment g = square_with(elastic({from, to}, 0.01)).finest();
  const auto sheared = [](const Vec2& p) { return Vec3(1.05 * p.x() + 0.2 * p.y(), p.y(), 0); };
  const double stretch = (sheared(to) - sheared(from)).norm() / (to - from).norm();
  const double expected =
      30 * (to - from).norm() / 1.2 * fabric::band_law(1.2 * stretch - 1).energy;
  EXPECT_NEAR(energy(g, sheared), expected, 1e-6 * expected);
}

TEST(LayBand, ReachesNoFartherThanItsEnds) {
  const Garment g = square_with(elastic({{.2, .1}, {.2, .3}}, 0.01)).finest();
  for (const fabric::BandPart& part : g.bands)
    for (const fabric::BandTriangle& t : part.triangles)
      for (const Vec2& corner : g.triangle_uv[t.triangle]) {
        EXPECT_GT(corner.y(), .1 - 0.015);
        EXPECT_LT(corner.y(), .3 + 0.015);
        EXPECT_NEAR(corner.x(), .2, 0.02);
      }
}

TEST(LayBand, NothingIsLaidForWhatDoesNotPull) {
  Attachment cable = elastic({{.2, .1}, {.2, .3}}, 0.01);
  std::get<Cable>(cable.part).axial_stiffness = 0;
  EXPECT_TRUE(square_with(cable).finest().bands.empty());
}

}  // namespace
}  // namespace loosefit::garment
