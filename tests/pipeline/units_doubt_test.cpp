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

}  // namespace
}  // namespace loosefit::pipeline
