#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "loosefit/base/error.h"
#include "loosefit/io/garmentcode_write.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_writer.h"
#include "loosefit/pipeline/case_body.h"
#include "loosefit/pipeline/case_pattern.h"
#include "support/body_fixture.h"

// The garments of a scenario at their defaults are drafted on every body.
namespace loosefit::pipeline {
namespace {

scenario::GarmentSpec garment_of(const std::string& section) {
  return io::parse_scenario("[garment]\n" + section, "case.toml").studied().spec;
}

std::string refusal(const std::string& section, const body::Body& body) {
  try {
    make_pattern(garment_of(section), body);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return {};
}

TEST(AdaptedBodies, PeopleOfAllKindsGetTheUsualGarments) {
  std::mt19937 random(3);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * double(random() % 100001) / 1e5;
  };
  for (int i = 0; i < 24; ++i) {
    body::BodyParameters p;
    p.sex = uniform(0, 1);
    p.age = i % 2 ? uniform(3.5, 14) : uniform(14, 80);
    p.height = uniform(0.1, 0.9);
    p.weight = uniform(0.05, 0.95);
    p.muscle = uniform(0.05, 0.95);
    p.proportions = uniform(0.1, 0.9);
    const body::Body body = body_model().build(p, {radians(40.0), 0, 0});
    SCOPED_TRACE(testing::Message() << i << ": " << body.measured.at("height") << " m, chest "
                                    << body.measured.at("chest") << " m");
    EXPECT_EQ(refusal("pattern = \"t-shirt\"", body), "");
    EXPECT_EQ(refusal("pattern = \"t-shirt\"\nfit = { chest = 0.30 }", body), "");
    EXPECT_EQ(refusal(i % 2 ? "" : "size = \"child-142\"\npattern = \"t-shirt\"", body), "");
  }
}

TEST(AdaptedBodies, BoyOf135WithALooseChest) {
  scenario::ScenarioBody wished;
  wished.sex = 1, wished.age = 9.5, wished.height = 1.35;
  const body::Body body = make_body(wished).body;
  const CasePattern shirt =
      make_pattern(garment_of("pattern = \"t-shirt\"\nfit = { chest = 0.30 }"), body);
  EXPECT_NEAR(shirt.fit.at("chest"), 0.30, 1e-6);
  ASSERT_EQ(shirt.warnings.size(), 1u);
  EXPECT_NE(shirt.warnings[0].find("sleeve_length"), std::string::npos) << shirt.warnings[0];
  EXPECT_EQ(refusal("fit = { chest = 0.30, hip = 0.20, sleeve = 0.35, wrist = 0.35, "
                    "sleeve_length = 0.42, neck_ease = 0 }",
                    body),
            "");
  const std::string said =
      refusal("pattern = \"t-shirt\"\nfit = { chest = 0.3, sleeve_length = 0.25 }", body);
  EXPECT_EQ(said.rfind("fit.sleeve_length: found 0.25", 0), 0u) << said;
}

// What a run has written out is drafted as it was.
TEST(AdaptedBodies, ResolvedScenarioAdaptsAlike) {
  scenario::Scenario scenario =
      io::parse_scenario("[garment]\npattern = \"t-shirt\"\nfit = { chest = 0.30 }\n", "case.toml");
  const scenario::Scenario again = io::parse_scenario(io::scenario_toml(scenario), "case.toml");
  EXPECT_EQ(again.studied().spec.adapt, scenario.studied().spec.adapt);
  scenario::ScenarioBody wished;
  wished.sex = 1, wished.age = 7, wished.height = 1.2;
  const body::Body body = make_body(wished).body;
  const CasePattern a = make_pattern(scenario.studied().spec, body),
                    b = make_pattern(again.studied().spec, body);
  EXPECT_EQ(io::garmentcode_text(a.pattern), io::garmentcode_text(b.pattern));
  EXPECT_EQ(a.warnings, b.warnings);
  EXPECT_FALSE(a.warnings.empty());
}

TEST(AdaptedBodies, PublicScanGetsATShirt) {
  const std::string file =
      std::string(LOOSEFIT_SOURCE_DIR) + "/../shared/bodies/f_smpl_average_A40.obj";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  scenario::ScenarioBody wished;
  wished.file = file;
  const body::Body body = make_body(wished).body;
  EXPECT_EQ(refusal("pattern = \"t-shirt\"", body), "");
  EXPECT_EQ(refusal("", body), "");
}

TEST(AdaptedBodies, AdaptNamesWhatMayGiveWay) {
  EXPECT_EQ(garment_of("fit = { chest = 0.1 }\nadapt = [\"wrist\", \"sleeve\"]").adapt,
            (std::vector<std::string>{"sleeve", "wrist"}));
  const auto usual = garment_of("fit = { chest = 0.1 }").adapt;
  EXPECT_EQ(std::count(usual.begin(), usual.end(), "chest"), 0);
  EXPECT_EQ(std::count(usual.begin(), usual.end(), "sleeve_length"), 1);
  EXPECT_THROW(garment_of("adapt = [\"sleeves\"]"), InvalidInput);
}

}  // namespace
}  // namespace loosefit::pipeline
