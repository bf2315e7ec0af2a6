#include "loosefit/pipeline/case_ease.h"

#include <gtest/gtest.h>

#include <numbers>

namespace loosefit::pipeline {
namespace {

using Stations = std::vector<StationEase>;

maps::BodyLoad pressing(double newton, double squeezed = 0) {
  maps::BodyLoad load;
  load.normal_force = newton;
  load.weight = 1;
  load.between_arm_and_trunk = squeezed;
  for (const std::string& limb : maps::limb_names())
    load.of_limb[limb] = load.free_of_limb[limb] = 0;
  load.of_limb["forearm_L"] = 0.75 * newton;
  load.of_limb["trunk"] = 0.25 * newton;
  load.free_of_limb["forearm_L"] = 0.75 * load.free_force();
  load.free_of_limb["trunk"] = 0.25 * load.free_force();
  return load;
}

const Stations kLoose = {{"chest", 0.12, 0.12}, {"sleeve", 0.2, 0.2}, {"elbow", 0.02, {}}};

TEST(CaseEase, ALittleAskedEaseThatIsMissingIsToldToo) {
  EXPECT_EQ(ease_warnings({{"chest", -0.01, 0.04}}, {}),
            (std::vector<std::string>{"chest: -1 % of ease where 4 % was asked"}));
  EXPECT_EQ(ease_warnings({{"hip", -0.03, 0.0}}, {}).size(), 1u);
  // Two hundredths are less than bodies are taped to.
  EXPECT_TRUE(ease_warnings({{"chest", 0.021, 0.04}, {"hip", -0.02, 0.0}}, {}).empty());
  // What was asked to lie close is missed either way, on limbs as on the trunk.
  EXPECT_EQ(ease_warnings({{"hip", -0.15, -0.1}}, {}).size(), 1u);
  EXPECT_EQ(ease_warnings({{"sleeve at the wrist", 0.0, -0.1}}, {}),
            (std::vector<std::string>{"sleeve at the wrist: 0 % of ease where -10 % was asked"}));
}

TEST(CaseEase, StationsOfADraftKnowWhatWasAskedAndThoseOfASizeDoNot) {
  CasePattern pattern;
  pattern.levels = {{"chest", 1.0, 0.9}, {"neck", 0.4, {}}};
  pattern.fit = {{"chest", 1.0 / 0.9 - 1}};
  scenario::GarmentSpec spec;
  spec.fit["chest"] = 0.15;
  const Stations asked = station_eases(pattern, spec);
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_EQ(asked[0].name, "chest");
  EXPECT_EQ(asked[0].asked, 0.15);
  EXPECT_NEAR(asked[0].cut, 0.111, 1e-3);
  spec.size = "women-38";
  EXPECT_FALSE(station_eases(pattern, spec)[0].asked.has_value());
}

TEST(CaseEase, ATightWaistThatNobodyAskedForDoesNotSilenceAShirtThatPresses) {
  CasePattern pattern;
  pattern.levels = {{"chest", 1.0, 0.9}, {"waist", 0.7, 0.72}};
  pattern.fit = {{"chest", 0.11}, {"waist", -0.03}};
  scenario::GarmentSpec spec;
  spec.fit["chest"] = 0.11;
  const Stations stations = station_eases(pattern, spec);
  EXPECT_FALSE(stations[1].asked.has_value());
  EXPECT_FALSE(stations[1].drawn_in) << "it may be asked for";
  EXPECT_TRUE(is_asked_loose(stations));
  EXPECT_EQ(ease_warnings(stations, pressing(25)).size(), 1u);
  // A level that cannot be asked for is drawn in by the draft, as a waistband.
  pattern.levels[1].name = "waistband", pattern.fit = {{"chest", 0.11}, {"waistband", -0.03}};
  EXPECT_TRUE(station_eases(pattern, spec)[1].drawn_in);
  EXPECT_FALSE(is_asked_loose(station_eases(pattern, spec)));
}

TEST(CaseEase, LimbsAreToldByWhatTheyBearFreeOfTheArms) {
  maps::BodyLoad load = pressing(30, 18);  // of which the arms squeeze 18
  load.of_limb = load.free_of_limb;
  load.of_limb["upper_arm_L"] += 18;
  const auto lines = ease_warnings({{"chest", 0.12, 0.12}}, load);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("forearm_L 75 %"), std::string::npos) << lines[0];
  EXPECT_EQ(lines[0].find("upper_arm_L"), std::string::npos) << lines[0];
}

TEST(CaseEase, LeastIsThatOfAllStationsAskedForOrNot) {
  EXPECT_EQ(least_cut_ease(kLoose)->name, "elbow");
  EXPECT_FALSE(least_cut_ease({}).has_value());
}

TEST(CaseEase, SaysInWordsWhereAStationIsNotAsAsked) {
  const auto lines = ease_warnings({{"chest", 0.12, 0.12}, {"forearm sleeve", 0.02, 0.15}}, {});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0], "forearm sleeve: 2 % of ease where 15 % was asked");
  // Two thirds of it pass, and so does what was asked to be tight.
  EXPECT_TRUE(ease_warnings({{"sleeve", 0.101, 0.15}, {"wrist", -0.02, 0.0}}, {}).empty());
  EXPECT_EQ(ease_warnings({{"sleeve", 0.099, 0.15}}, {}).size(), 1u);
}

TEST(CaseEase, ALooseGarmentThatPressesWithManyWeightsIsTold) {
  EXPECT_TRUE(ease_warnings(kLoose, pressing(9.9)).empty());
  const auto lines = ease_warnings(kLoose, pressing(77));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("77 times its weight"), std::string::npos) << lines[0];
  EXPECT_NE(lines[0].find("forearm_L 75 %"), std::string::npos) << lines[0];
  EXPECT_NE(lines[0].find("trunk 25 %"), std::string::npos) << lines[0];
}

TEST(CaseEase, WhatIsSqueezedBetweenArmAndTrunkIsNotHeldAgainstTheCut) {
  EXPECT_TRUE(ease_warnings(kLoose, pressing(30, 22)).empty());
  EXPECT_EQ(ease_warnings(kLoose, pressing(30, 18)).size(), 1u);
}

TEST(CaseEase, AGarmentThatWasAskedToBeTightMayPress) {
  EXPECT_TRUE(is_asked_loose(kLoose));
  const Stations tight = {{"chest", -0.1, -0.1}, {"sleeve", 0.2, 0.2}};
  EXPECT_FALSE(is_asked_loose(tight));
  EXPECT_TRUE(ease_warnings(tight, pressing(200)).empty());
}

// A tee from a file that is 8 % narrower than the hips presses with 165 weights.
TEST(CaseEase, AGarmentThatNobodyAskedAnythingOfIsToldWhenItPressesWithManyMoreWeights) {
  const Stations nobody_asked = {{"chest", 0.3, {}}};
  EXPECT_FALSE(is_asked_loose(nobody_asked));
  EXPECT_TRUE(ease_warnings(nobody_asked, pressing(29)).empty());
  const auto lines = ease_warnings(nobody_asked, pressing(165));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("presses with 165 times its weight"), std::string::npos) << lines[0];
  EXPECT_NE(lines[0].find("too small, caught, or meant to be tight"), std::string::npos)
      << lines[0];
  // The waistband of a draft presses by what the draft is for.
  EXPECT_TRUE(ease_warnings({{.name = "waistband", .cut = -0.05, .drawn_in = true}}, pressing(165))
                  .empty());
}

TEST(CaseEase, WhatPressesIsToldWithTheStationThatIsTooSmallForItsCloth) {
  fabric::Material woven;
  woven.name = "woven", woven.stiffness_weft = 2000;
  const Stations narrow = {{.name = "hip", .cut = -0.08, .body = 1.0},
                           {.name = "chest", .cut = 0.1, .body = 0.9},
                           {.name = "trunk at the hip", .cut = -0.09, .body = 1.0}};
  // Laplace: 2000 N/m · (1/0.92 − 1) over 1 m/(2π).
  EXPECT_NEAR(pressure_when_closed(narrow[0], woven), 1093, 1);
  EXPECT_EQ(pressure_when_closed(narrow[1], woven), 0);
  const auto lines = ease_warnings(narrow, pressing(165), woven);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("; trunk at the hip is cut 9.0 % narrower than the body, where woven "
                          "closes with 1.2 kPa; "),
            std::string::npos)
      << lines[0];
  // A cardigan that does not close in front need not press.
  EXPECT_TRUE(ease_warnings(narrow, pressing(5), woven).empty());
  // A measured law is followed.
  fabric::Material knit = woven;
  knit.curve_weft = {{0.08 / 0.92, 20}, {0.2, 400}};
  EXPECT_NEAR(pressure_when_closed(narrow[0], knit), 20 * 2 * std::numbers::pi, 1e-6);
  // What was asked to be tight is no news.
  const auto asked = ease_warnings({{.name = "chest", .cut = 0.2, .asked = 0.2, .body = 1},
                                    {.name = "waist", .cut = -0.01, .asked = {}, .body = 0.7},
                                    {.name = "hip", .cut = 0.07, .asked = 0.08, .body = 1}},
                                   pressing(165), woven);
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_NE(asked[0].find("; waist is cut 1.0 % narrower"), std::string::npos) << asked[0];
}

// Elastic waistbands hold trousers up by pressing.
TEST(CaseEase, ALevelThatTheDraftMakesTightMayPress) {
  CasePattern pattern;
  pattern.levels = {{"hip", 1.08, 1.0}, {"waistband", 0.66, 0.70}};
  pattern.fit = {{"hip", 0.08}, {"waistband", -0.06}};
  scenario::GarmentSpec spec;
  spec.fit["hip"] = 0.08;
  EXPECT_FALSE(is_asked_loose(station_eases(pattern, spec)));
  pattern.fit["waistband"] = 0.02;
  EXPECT_TRUE(is_asked_loose(station_eases(pattern, spec)));
}

TEST(CaseEase, StrainBeyondItsRangeIsToldWithShareLargestAndRange) {
  maps::StrainRange range;
  range.warp = {0.167, 1.1, 0.34};
  range.weft = {0.167, 0.1, 0};
  range.shear = {0, 0.5, 0};
  scenario::MaterialCard card;
  card.material.name = "jersey";
  const auto lines = strain_range_warnings(range, card);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("jersey"), std::string::npos);
  EXPECT_NE(lines[0].find("warp on 34 % of the cloth, up to 110 % where 16.7 %"), std::string::npos)
      << lines[0];
  EXPECT_EQ(lines[0].find("weft"), std::string::npos);
  range.warp.share_beyond = 0.0005;  // a triangle at a corner
  EXPECT_TRUE(strain_range_warnings(range, card).empty());
}

// Constants of one's own have no range: what they cannot tell is said where it would matter.
TEST(CaseEase, StrainWithoutAStatedRangeIsTold) {
  maps::StrainRange range;
  scenario::MaterialCard card;
  card.material.name = "mine";
  range.warp = {.limit = 0, .largest = 0.74, .share_beyond = 0};
  range.weft = {.limit = 0, .largest = 0.02, .share_beyond = 0};
  const auto lines = strain_range_warnings(range, card);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("along the warp by up to 74 %"), std::string::npos) << lines[0];
  EXPECT_NE(lines[0].find("valid_strain_warp"), std::string::npos) << lines[0];
  range.warp.limit = 0.8;
  EXPECT_TRUE(strain_range_warnings(range, card).empty());
}

TEST(CaseEase, PressureBeyondComfortIsToldWithItsPlace) {
  maps::PressureField field;
  field.contact = {5000, 12000, 3900, 0};
  field.area = {8e-4, 4e-4, 1, 1};
  const std::vector<body::Region> regions = {body::Region::chest, body::Region::forearm_left,
                                             body::Region::chest, body::Region::chest};
  const auto lines = comfort_warnings(field, regions);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("up to 12 kPa) on 12 cm²"), std::string::npos) << lines[0];
  EXPECT_NE(lines[0].find("forearm_sleeve_L with 4.8 N"), std::string::npos) << lines[0];
  field.area[1] = 1e-4;  // 9 cm² in all: a fold in an armpit
  EXPECT_TRUE(comfort_warnings(field, regions).empty());
  EXPECT_TRUE(comfort_warnings({}, {}).empty());
}

}  // namespace
}  // namespace loosefit::pipeline
