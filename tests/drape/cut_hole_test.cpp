#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "loosefit/drape/openings.h"
#include "loosefit/fabric/material.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/pattern/hole.h"
#include "support/placed_top.h"

// Holes cut into pieces are openings of the garment.
namespace loosefit::drape {
namespace {

using namespace testing_support;
using kinds::OpeningUse;

pattern::PanelHole circle(const Vec2& centre, double radius) {
  pattern::PanelHole hole{"neck hole", {}};
  for (int i = 0; i < 72; ++i)
    hole.points.push_back(centre +
                          radius * Vec2(std::cos(2 * kPi * i / 72), std::sin(2 * kPi * i / 72)));
  return hole;
}

std::map<OpeningUse, int> uses(const std::vector<Opening>& openings) {
  std::map<OpeningUse, int> count;
  for (const Opening& opening : openings) ++count[opening.use];
  return count;
}

/// Front and back sewn at the sides and all along the top, with armholes between: no neck but a
/// hole.
pattern::Pattern tunic() {
  const double w = 0.3, length = 0.75, under = 0.5, tip = 0.25;
  const std::vector<Vec2> outline = {{-w, 0},       {w, 0},         {w, under},
                                     {tip, length}, {-tip, length}, {-w, under}};
  pattern::Pattern p;
  for (const bool back : {false, true}) {
    pattern::Panel panel = polygon_panel(back ? "back" : "front", outline);
    panel.rotation.col(0) = Vec3::UnitX();
    panel.rotation.col(1) = Vec3::UnitZ();
    panel.rotation.col(2) = -Vec3::UnitY();
    if (back) panel.rotation.col(0) *= -1, panel.rotation.col(2) *= -1;
    panel.translation = Vec3(0, back ? 0.22 : -0.22, 0.7);
    p.panels.push_back(panel);
  }
  p.stitches = {stitch(0, 1, 1, 5), stitch(0, 5, 1, 1), stitch(0, 3, 1, 3)};
  return p;
}

TEST(CutHole, InTheMiddleOfATopIsForNothingAndTheOthersStayWhatTheyAre) {
  pattern::Pattern pattern = PlacedTop().pattern();
  const garment::Garment whole = garment::assemble(pattern, 0.03, fabric::Material{});
  const auto before = uses(garment_openings(whole, pattern));
  ASSERT_EQ(before.at(OpeningUse::neck), 1);
  for (const double height : {0.15, 0.25, 0.35})
    for (const double beside : {-0.1, 0.0, 0.08}) {
      const double radius = 0.05 + 0.1 * height;
      pattern.panels[0].holes = {circle({beside, height}, radius)};
      const garment::Garment cut = garment::assemble(pattern, 0.03, fabric::Material{});
      EXPECT_NEAR(whole.area - cut.area, kPi * radius * radius, 0.05 * kPi * radius * radius);
      const std::vector<Opening> openings = garment_openings(cut, pattern);
      auto expected = before;
      ++expected[OpeningUse::unknown];
      EXPECT_EQ(uses(openings), expected) << height << " " << beside;
      const auto hole = std::ranges::find(openings, OpeningUse::unknown, &Opening::use);
      EXPECT_NEAR(hole->girth, 2 * kPi * radius, 0.02 * hole->girth);
    }
}

TEST(CutHole, OfATunicIsItsNeck) {
  for (const double radius : {0.09, 0.12}) {
    pattern::Pattern pattern = tunic();
    pattern.panels[0].holes = {circle({0, 0.75 - 0.02 - radius}, radius)};
    const auto openings =
        garment_openings(garment::assemble(pattern, 0.03, fabric::Material{}), pattern);
    const std::map<OpeningUse, int> expected{{OpeningUse::neck, 1},
                                             {OpeningUse::hem, 1},
                                             {OpeningUse::left_arm, 1},
                                             {OpeningUse::right_arm, 1}};
    EXPECT_EQ(uses(openings), expected);
  }
}

}  // namespace
}  // namespace loosefit::drape
