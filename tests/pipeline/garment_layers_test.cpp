#include "loosefit/pipeline/garment_layers.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "loosefit/base/error.h"
#include "loosefit/drape/cloth_model.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_place.h"
#include "loosefit/pipeline/summary.h"
#include "support/measured_woman.h"

namespace loosefit::pipeline {
namespace {

garment::Garment triangle(double area) {
  garment::Garment g;
  g.vertex_count = 3;
  g.triangles = {{0, 1, 2}};
  g.area = area;
  return g;
}

/// One triangle of cloth over another.
CaseResult two_layers() {
  CaseResult result;
  result.scenario = io::parse_scenario(
      "[material]\nname = \"wool\"\nfriction_body = 0.5\nfriction_self = 0.6\n"
      "[[under]]\npattern = \"t-shirt\"\nfriction = 0.2\n[under.material]\nname = \"silk\"\n",
      "case.toml");
  result.garments.resize(2);
  result.garments[0].hierarchy.levels = {triangle(0.5)};
  result.garments[0].pattern.pattern.name = "t-shirt";
  result.garments[1].hierarchy.levels = {triangle(0.8)};
  drape::Drape all;
  for (int i = 0; i < 6; ++i) all.positions.emplace_back(i, 0, 0);
  all.body_normal_force = {1, 2, 3, 0, 0, 0.5};
  all.certificate = {1e-4, 1e-3, 0, 2, "converged", 1};
  result.take_drapes(split_drape(all, result.scenario, result.garments));
  return result;
}

TEST(GarmentLayers, EachGarmentGetsItsPartOfTheDrapeAndTheCertificateOfAll) {
  const CaseResult result = two_layers();
  const drape::Drape &inner = result.garments[0].drape, &studied = result.studied().drape;
  ASSERT_EQ(inner.positions.size(), 3u);
  ASSERT_EQ(studied.positions.size(), 3u);
  EXPECT_EQ(inner.positions[2], Vec3(2, 0, 0));
  EXPECT_EQ(studied.positions[0], Vec3(3, 0, 0));
  EXPECT_EQ(studied.body_normal_force, (std::vector<double>{0, 0, 0.5}));
  EXPECT_EQ(inner.certificate.intersections_self, 2);
  const geometry::TriangleMesh under = surface_under_studied(result);
  EXPECT_EQ(under.vertices.size(), 3u);
  EXPECT_EQ(under.triangles.size(), 1u);
}

TEST(GarmentLayers, FrictionOfADonningHoldsForEveryContact) {
  const CaseResult result = two_layers();
  const std::vector<drape::ClothLayer> layers = cloth_layers(result.scenario, result.garments, 0.5);
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_EQ(layers[0].garment, &result.garments[0].hierarchy) << "the innermost first";
  EXPECT_NEAR(*layers[0].friction_over, 0.1, 1e-15);
  EXPECT_NEAR(layers[1].material.friction_body, 0.25, 1e-15);
  EXPECT_NEAR(layers[1].material.friction_self, 0.3, 1e-15);
  std::vector<drape::ModelLayer> parts;
  for (const drape::ClothLayer& l : layers)
    parts.push_back({nullptr, l.material, 0, l.friction_over});
  EXPECT_NEAR(drape::layer_friction(parts)(0, 1), 0.1, 1e-15);
}

TEST(GarmentLayers, SummaryListsAllGarmentsFromTheSkinOutwards) {
  const auto json = nlohmann::json::parse(summary_json(two_layers()));
  EXPECT_EQ(json["intersections"]["layers"], 1);
  ASSERT_EQ(json["garments"].size(), 2u);
  EXPECT_EQ(json["garments"][0]["pattern"], "t-shirt");
  EXPECT_EQ(json["garments"][0]["material"]["name"], "silk");
  EXPECT_EQ(json["garments"][0]["normal_force_on_body_N"], 6.0);
  EXPECT_EQ(json["garments"][1]["area_m2"], 0.8);
  EXPECT_EQ(json["garments"][1]["normal_force_on_body_N"], 0.5);
  EXPECT_EQ(json["garment"]["area_m2"], 0.8) << "that of the studied garment";
  CaseResult alone;
  alone.scenario = io::default_scenario();
  alone.studied().hierarchy.levels = {triangle(1)};
  EXPECT_FALSE(nlohmann::json::parse(summary_json(alone)).contains("garments"));
}

TEST(GarmentLayers, WhatCannotBeDraftedIsToldWithItsSection) {
  const body::Body body = support::measured_woman();
  const scenario::Scenario scenario = io::parse_scenario(
      "[[under]]\n[[under]]\npattern = \"t-shirt\"\nfit = { sleeve = 2 }\n", "case.toml");
  try {
    make_patterns(scenario, body);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place().key, "under[1].fit.sleeve");
    const std::string told = io::in_scenario(error, scenario).what();
    EXPECT_NE(told.find("case.toml:4: under[1].fit.sleeve"), std::string::npos) << told;
  }
}

}  // namespace
}  // namespace loosefit::pipeline
