#include "loosefit/pipeline/units_doubt.h"

#include <gtest/gtest.h>

#include "loosefit/kinds/registry.h"
#include "loosefit/pipeline/file_girths.h"
#include "support/simple_patterns.h"

// Pattern files whose units are others than they say.
namespace loosefit::pipeline {
namespace {

using namespace testing_support;

const kinds::NamedValues kBody = {
    {"chest", 0.92},       {"waist", 0.76},        {"hip", 0.98},        {"upper_arm", 0.29},
    {"hps_to_bust", 0.27}, {"hps_to_waist", 0.43}, {"hps_to_hip", 0.63}, {"arm_length", 0.56},
    {"wrist", 0.16},       {"crotch_height", .76}, {"hip_level", 0.86}};

/// The size of a kind that is to fit, its lengths taken for as many others.
UnitsDoubt doubt(const std::string& kind, double times) {
  pattern::Pattern pattern = kinds::garment_kind(kind).draft({{}, "women-38", {}, {}}).pattern;
  pattern.kind = "pattern-file";
  for (pattern::Panel& panel : pattern.panels) {
    panel.translation *= times;
    for (Vec2& v : panel.vertices) v *= times;
    for (pattern::PanelEdge& edge : panel.edges) {
      for (Vec2& k : edge.knots) k *= times;
      for (pattern::EdgeCurve& curve : edge.curves) {
        curve.radius *= times;
        for (Vec2& c : curve.control) c *= times;
      }
    }
  }
  const UnitsDoubt first = units_doubt(pattern, {});
  return first.wears_nobody ? first : units_doubt(pattern, file_girths(pattern, kBody).levels);
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(UnitsDoubt, AGarmentThatFitsHasNone) {
  for (const char* kind : {"t-shirt", "long-sleeve-shirt"})
    for (const double times : {1.0, 0.8, 1.5}) EXPECT_EQ(doubt(kind, times).found, "") << times;
}

TEST(UnitsDoubt, InchesForCentimetresAreToldWithTheMeasuresFound) {
  const UnitsDoubt large = doubt("t-shirt", 2.54), small = doubt("t-shirt", 1 / 2.54);
  EXPECT_TRUE(holds(large.found, "m at the chest, the body 0.92 m")) << large.found;
  EXPECT_TRUE(holds(large.hint, "2.54 times too large")) << large.hint;
  EXPECT_FALSE(large.wears_nobody) << "it is draped, and falls off";
  EXPECT_TRUE(holds(small.found, "m at the chest, the body 0.92 m")) << small.found;
  EXPECT_TRUE(holds(small.hint, "2.54 times too small")) << small.hint;
}

TEST(UnitsDoubt, MillimetresForCentimetresAreRefusedBeforeAnythingIsMeshed) {
  const UnitsDoubt large = doubt("t-shirt", 10), small = doubt("t-shirt", 0.1);
  EXPECT_TRUE(large.wears_nobody && small.wears_nobody);
  EXPECT_TRUE(holds(large.hint, "10 times too large")) << large.hint;
  EXPECT_TRUE(holds(small.hint, "10 times too small")) << small.hint;
}

TEST(UnitsDoubt, LevelsWithoutABodySayNothing) {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("front", 0.5, 0.6)};
  EXPECT_EQ(units_doubt(pattern, {{"hem", 9.0, {}}}).found, "");
  EXPECT_NE(units_doubt(pattern, {{"hem", 9.0, {}}, {"chest", 3.0, 0.9}}).found, "");
}

/// Front and back of a tube, one behind the other.
pattern::Pattern tube(const std::string& name, double girth, double height, double low) {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel(name + "front", girth / 2, height),
                    rectangle_panel(name + "back", girth / 2, height)};
  pattern.panels[0].rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  pattern.panels[0].translation = {-girth / 4, -0.2, low};
  pattern.panels[1].rotation << -1, 0, 0, 0, 0, 1, 0, 1, 0;
  pattern.panels[1].translation = {girth / 4, 0.2, low};
  pattern.stitches = {stitch(0, 1, 1, 3), stitch(0, 3, 1, 1)};
  return pattern;
}

UnitsDoubt doubt_of(const pattern::Pattern& pattern) {
  const FileGirths girths = file_girths(pattern, kBody);
  EXPECT_FALSE(girths.levels.empty());
  return units_doubt(pattern, girths.levels);
}

TEST(UnitsDoubt, TubesThatNothingSaysToBeSkirtsAreNotHeldAgainstTheWaist) {
  EXPECT_EQ(doubt_of(tube("", 0.27, 0.20, 0.10)).found, "") << "a sleeve for an ankle";
  EXPECT_EQ(doubt_of(tube("", 4.0, 0.60, 0.90)).found, "") << "a wide cape";
  EXPECT_TRUE(doubt_of(tube("skirt ", 0.27, 0.20, 0.60)).wears_nobody);
  EXPECT_NE(doubt_of(tube("skirt ", 2.4, 0.60, 0.40)).found, "");
}

TEST(UnitsDoubt, ASmallPieceIsNone) {
  for (const double side : {0.07, 0.09, 0.11, 0.2}) {
    pattern::Pattern pattern;
    pattern.panels = {rectangle_panel("cup", side, 0.8 * side)};
    EXPECT_EQ(units_doubt(pattern, {}).found, "") << side;
  }
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("cup", 0.02, 0.03)};
  EXPECT_TRUE(units_doubt(pattern, {}).wears_nobody);
}

TEST(UnitsDoubt, AFrillOfOneLongStripIsNoReasonToRefuseASkirt) {
  pattern::Pattern pattern = tube("skirt ", 0.9, 0.6, 0.4);
  pattern.panels.push_back(rectangle_panel("frill", 3.2, 0.1));
  EXPECT_EQ(units_doubt(pattern, {}).found, "");
  pattern.panels.push_back(rectangle_panel("train", 3.2, 2.0));
  EXPECT_TRUE(units_doubt(pattern, {}).wears_nobody);
  pattern.panels.pop_back();
  pattern.panels.back() = rectangle_panel("frill", 90, 0.1);
  EXPECT_TRUE(units_doubt(pattern, {}).wears_nobody);
}

TEST(UnitsDoubt, AWaistCountsAsElasticsDrawItIn) {
  pattern::Pattern pattern = tube("skirt ", 2.2, 0.5, 0.5);
  EXPECT_NE(doubt_of(pattern).found, "");
  for (pattern::Panel& panel : pattern.panels)
    panel.edges[2].elastic = pattern::EdgeElastic{.ratio = 0.35};
  EXPECT_EQ(doubt_of(pattern).found, "");
}

}  // namespace
}  // namespace loosefit::pipeline
