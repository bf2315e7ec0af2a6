#include "loosefit/pipeline/file_girths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "loosefit/io/read_pattern.h"
#include "loosefit/kinds/body_measures.h"
#include "loosefit/kinds/registry.h"
#include "support/body_fixture.h"
#include "support/simple_patterns.h"

namespace loosefit::pipeline {
namespace {

using namespace testing_support;

const kinds::NamedValues kBody = {
    {"chest", 0.88},        {"waist", 0.72},      {"hip", 0.97},        {"upper_arm", 0.28},
    {"wrist", 0.16},        {"thigh", 0.55},      {"knee", 0.36},       {"hps_to_bust", 0.27},
    {"hps_to_waist", 0.43}, {"hps_to_hip", 0.63}, {"arm_length", 0.56}, {"crotch_height", 0.76},
    {"hip_level", 0.86}};

const kinds::FitLevel* find(const FileGirths& girths, const std::string& name) {
  const auto at = std::ranges::find(girths.levels, name, &kinds::FitLevel::name);
  return at == girths.levels.end() ? nullptr : &*at;
}

/// A draft as if it came from elsewhere.
pattern::Pattern as_file(pattern::Pattern pattern) {
  pattern.kind = "pattern-file";
  for (pattern::Panel& panel : pattern.panels) {
    panel.part.clear();
    for (pattern::PanelEdge& edge : panel.edges) edge.part.clear();
  }
  return pattern;
}
pattern::Pattern as_file(const std::string& kind, const std::string& size) {
  return as_file(kinds::garment_kind(kind).draft({{}, size, {}, {}}).pattern);
}

double drafted(const std::string& kind, const std::string& size, const std::string& level) {
  const kinds::GarmentKind& of = kinds::garment_kind(kind);
  const auto made = of.draft({{}, size, {}, {}});
  for (const kinds::FitLevel& l : of.levels(made.pattern, made.measures, made.fit))
    if (l.name == level) return l.garment;
  return 0;
}

/// Two rectangles one behind the other: front 0.5, back 0.46 m wide, 0.6 m high, up to z = 1.
pattern::Pattern straight_skirt() {
  pattern::Pattern pattern;
  pattern.panels = {rectangle_panel("front", 0.5, 0.6), rectangle_panel("back", 0.46, 0.6)};
  pattern.panels[0].rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  pattern.panels[0].translation = {-0.25, -0.2, 0.4};
  pattern.panels[1].rotation << -1, 0, 0, 0, 0, 1, 0, 1, 0;
  pattern.panels[1].translation = {0.23, 0.2, 0.4};
  pattern.stitches = {stitch(0, 1, 1, 3), stitch(0, 3, 1, 1)};
  return pattern;
}

TEST(FileGirths, OfASkirtAreTheSumsOfItsWidths) {
  const FileGirths girths = file_girths(straight_skirt(), kBody);
  for (const auto& [name, body] : {std::pair{"waist", 0.72}, {"hip", 0.97}}) {
    const kinds::FitLevel* level = find(girths, name);
    ASSERT_TRUE(level) << name;
    EXPECT_NEAR(level->garment, 0.96, 1e-3) << name;
    EXPECT_DOUBLE_EQ(level->body.value_or(0), body);
  }
  ASSERT_FALSE(girths.stations.empty());
  for (const kinds::FitStation& s : girths.stations) {
    EXPECT_EQ(s.limb, "trunk");
    EXPECT_GE(s.along, 0.43 - 1e-9) << "from the waist down";
    EXPECT_LE(s.along, 0.65 + 1e-9) << "down to the hips";
    EXPECT_NEAR(s.garment, 0.96, 1e-9);
  }
}

TEST(FileGirths, AreKnownWithoutABodyWhereThePiecesTellThem) {
  const FileGirths girths = file_girths(straight_skirt(), {});
  ASSERT_TRUE(find(girths, "waist"));
  EXPECT_NEAR(find(girths, "waist")->garment, 0.96, 1e-3);
  EXPECT_FALSE(find(girths, "waist")->body);
  EXPECT_FALSE(find(girths, "hip")) << "where the hip is the body tells";
}

TEST(FileGirths, OfAShirtAreThoseThatItsDraftWasCutTo) {
  const FileGirths girths = file_girths(as_file("long-sleeve-shirt", "women-38"), kBody);
  for (const char* name : {"chest", "waist", "upper arm", "wrist"})
    ASSERT_TRUE(find(girths, name)) << name;
  EXPECT_NEAR(find(girths, "chest")->garment, drafted("long-sleeve-shirt", "women-38", "chest"),
              0.02);
  EXPECT_NEAR(find(girths, "wrist")->garment, drafted("long-sleeve-shirt", "women-38", "wrist"),
              0.005);
  std::set<std::string> limbs;
  for (const kinds::FitStation& s : girths.stations) limbs.insert(s.limb);
  EXPECT_EQ(limbs, (std::set<std::string>{"arm", "trunk"}));
}

TEST(FileGirths, OfATrunkEndWhereTheMiddleOfItsHemIs) {
  const kinds::GarmentKind& kind = kinds::garment_kind("long-sleeve-shirt");
  kinds::NamedValues m = kind.sizes.front().measures;
  m["front_balance"] = 0.03;
  const pattern::Pattern shirt = as_file(kind.draft({m, "", {}, {}}).pattern);
  const auto girths_at = [&](double hip_level) {
    kinds::NamedValues body = kBody;
    body["hps_to_hip"] = hip_level;
    return file_girths(shirt, body);
  };
  const double hem = m.at("hps_to_hem");
  const FileGirths whole = girths_at(hem - 0.002);
  ASSERT_TRUE(find(whole, "hip"));
  const double girth = find(whole, "hip")->garment;
  // Below the middle of the back only the corners at its sides are left.
  for (const double below : {0.001, 0.004, 0.008, 0.012})
    EXPECT_FALSE(find(girths_at(hem + below), "hip")) << below;
  for (const kinds::FitStation& s : girths_at(hem + 0.02).stations)
    if (s.limb == "trunk") {
      EXPECT_GT(s.garment, 0.9 * girth) << s.along;
    }
}

TEST(FileGirths, OfTrousersAreThoseThatTheirDraftWasCutTo) {
  const body::Body woman = body_model().build(body::BodyParameters{}, body::kArmsApart);
  const kinds::GarmentKind& kind = kinds::garment_kind("trousers");
  const kinds::DraftedGarment made =
      kind.draft({kinds::draft_measures(kind, woman.measured), {}, {}, {}});
  const FileGirths girths = file_girths(as_file(made.pattern), woman.measured);
  int compared = 0;
  for (const kinds::FitLevel& level : kind.levels(made.pattern, made.measures, made.fit)) {
    if (level.name != "hip" && level.name != "thigh" && level.name != "knee") continue;
    ASSERT_TRUE(find(girths, level.name)) << level.name;
    EXPECT_NEAR(find(girths, level.name)->garment, level.garment, 0.05 * level.garment)
        << level.name;
    ++compared;
  }
  EXPECT_GE(compared, 2);
  ASSERT_TRUE(find(girths, "waist") && find(girths, "hem"));
  EXPECT_LT(find(girths, "waist")->garment, find(girths, "hip")->garment);
}

TEST(FileGirths, OfPublishedGarmentsAreThoseOfTheirPanels) {
  const std::string tee = LOOSEFIT_SOURCE_DIR "/../shared/garments/gpg_tee.json";
  if (!std::filesystem::exists(tee)) GTEST_SKIP();
  const FileGirths girths = file_girths(io::read_pattern(tee).pattern, kBody);
  ASSERT_TRUE(find(girths, "chest") && find(girths, "upper arm"));
  // Front and back are 433.3 mm wide each.
  EXPECT_NEAR(find(girths, "chest")->garment, 0.8667, 0.002);
  EXPECT_DOUBLE_EQ(find(girths, "chest")->body.value_or(0), 0.88);
}

TEST(FileGirths, WhatIsNotSewnHasNone) {
  pattern::Pattern loose = straight_skirt();
  loose.stitches.clear();
  EXPECT_TRUE(file_girths(loose, kBody).levels.empty());
}

}  // namespace
}  // namespace loosefit::pipeline
