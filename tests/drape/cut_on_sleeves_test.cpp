#include "loosefit/drape/cut_on_sleeves.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/garment/assemble.h"
#include "support/placed_top.h"
#include "support/shirt_on_body.h"

namespace loosefit::drape {
namespace {

using testing_support::polygon_panel;
using testing_support::stitch;

const body::PosedBody& woman() {
  static const body::PosedBody body = support::standing(support::adult_parameters(), 40);
  return body;
}

/// Front and back with sleeves of so much length that hang by `slope` below the level.
pattern::Pattern kimono(double sleeve, double slope) {
  const double w = 0.28, length = 0.75, n = 0.1, deep = 0.2, c = std::cos(slope),
               s = std::sin(slope);
  const Vec2 top(n + (w - n + sleeve) * c, length - (w - n + sleeve) * s),
      bottom = top - deep * Vec2(s, c), under(w, length - deep - (w - n) * s / c - 0.03);
  const auto mirrored = [](const Vec2& p) { return Vec2(-p.x(), p.y()); };
  pattern::Pattern p;
  for (const double side : {1.0, -1.0}) {
    pattern::Panel panel = polygon_panel(side > 0 ? "front" : "back", {{-w, 0},
                                                                       {w, 0},
                                                                       under,
                                                                       bottom,
                                                                       top,
                                                                       {n, length},
                                                                       {0, length - 0.08},
                                                                       {-n, length},
                                                                       mirrored(top),
                                                                       mirrored(bottom),
                                                                       mirrored(under)});
    panel.rotation.col(0) = side * Vec3::UnitX();
    panel.rotation.col(1) = Vec3::UnitZ();
    panel.rotation.col(2) = -side * Vec3::UnitY();
    panel.translation = Vec3(0, -0.22 * side, 0.6);
    p.panels.push_back(panel);
  }
  p.stitches = {stitch(0, 1, 1, 10), stitch(0, 2, 1, 9), stitch(0, 4, 1, 7),
                stitch(0, 7, 1, 4),  stitch(0, 9, 1, 2), stitch(0, 10, 1, 1)};
  return p;
}

std::optional<double> angle_of(const pattern::Pattern& pattern) {
  return cut_on_sleeve_angle(garment::assemble(pattern, 0.03, fabric::Material{}), pattern,
                             woman());
}

TEST(CutOnSleeves, AreAsFarFromTheVerticalAsTheyAreDrawn) {
  for (const double sleeve : {0.2, 0.4})
    for (const double slope : {0.0, 15.0, 30.0}) {
      const auto angle = angle_of(kimono(sleeve, radians(slope)));
      ASSERT_TRUE(angle) << sleeve << ' ' << slope;
      EXPECT_NEAR(degrees(*angle), 90 - slope, 1) << sleeve;
    }
}

TEST(CutOnSleeves, SewnOnesAndArmholesAreNone) {
  EXPECT_FALSE(angle_of(testing_support::PlacedTop().pattern(Vec3(0, 0, 0.7))));
  EXPECT_FALSE(angle_of(kimono(0, radians(10)))) << "armholes at the shoulders";
}

}  // namespace
}  // namespace loosefit::drape
