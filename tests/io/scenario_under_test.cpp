#include <gtest/gtest.h>

#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_writer.h"
#include "support/refused_scenario.h"

namespace loosefit::io {
namespace {

using support::expect_refused;

TEST(ScenarioUnder, WithoutTheSectionOneGarmentIsWorn) {
  const scenario::Scenario s = default_scenario();
  EXPECT_TRUE(s.worn_under().empty());
  EXPECT_EQ(scenario_toml(s).find("under"), std::string::npos);
}

TEST(ScenarioUnder, GarmentsAreReadFromTheSkinOutwardsEachWithItsCloth) {
  const scenario::Scenario s = parse_scenario(
      "[[under]]\npattern = \"t-shirt\"\nfit = { chest = 0.02 }\nfriction = 0.25\n"
      "[under.material]\nname = \"cotton-jersey\"\nthickness = 0.001\n"
      "[[under]]\nsize = \"women-38\"\n[under.material]\nname = \"wool-measured\"\n"
      "[garment]\nfit = { chest = 0.3 }\n",
      "case.toml");
  ASSERT_EQ(s.worn_under().size(), 2u);
  EXPECT_EQ(s.garments[0].spec.kind, "t-shirt");
  EXPECT_EQ(s.garments[0].spec.fit.at("chest"), 0.02);
  EXPECT_EQ(s.garments[0].spec.fit.at("sleeve_length"), 0.38);
  EXPECT_EQ(s.garments[0].spec.fit.at("wrist"), 0.20);
  EXPECT_EQ(s.garments[0].friction, 0.25);
  EXPECT_EQ(s.garments[0].material.key, "cotton-jersey");
  EXPECT_EQ(s.garments[0].material.material.thickness, 0.001);
  EXPECT_EQ(s.garments[1].spec.size, "women-38");
  EXPECT_FALSE(s.garments[1].friction.has_value());
  EXPECT_FALSE(s.garments[1].material.material.curve_warp.empty());
  EXPECT_EQ(s.studied().spec.fit.at("chest"), 0.3) << "the studied garment";
  EXPECT_EQ(s.studied().spec.fit.at("sleeve_length"), 1.0);

  const scenario::Scenario again = parse_scenario(scenario_toml(s), "again.toml");
  EXPECT_EQ(scenario_toml(again), scenario_toml(s));
  ASSERT_EQ(again.worn_under().size(), 2u);
  EXPECT_EQ(again.garments[0].friction, 0.25);
  EXPECT_EQ(again.garments[1].material.material.curve_warp.size(),
            s.garments[1].material.material.curve_warp.size());
}

TEST(ScenarioUnder, OddInputIsRefusedByName) {
  expect_refused("[under]\npattern = \"t-shirt\"", {"case.toml:1: under", "[[under]]"});
  expect_refused("[[under]]\npattern = \"tshirt\"", {"case.toml:2: under[0].pattern", "t-shirt"});
  expect_refused("[[under]]\nfriction = 4", {"case.toml:2: under[0].friction", "0 to 3"});
  expect_refused("[[under]]\n[[under]]\nfit = { chest = 9 }", {"under[1].fit.chest"});
  expect_refused("[[under]]\nmass = 2", {"under[0].mass"});
  expect_refused("[[under]]\n[under.material]\nname = \"coton\"", {"under[0].material.name"});
  expect_refused("[[under]]\nsize = \"women-38\"\nfit = { chest = 0.1 }", {"under[0].fit"});
  expect_refused("[[under]]\n[[under]]\n[[under]]\n[[under]]",
                 {"under", "4 garments", "at most 3"});
  expect_refused("[garment]\nfit = { sleeve_length = 0.1 }",
                 {"case.toml:2: garment.fit.sleeve_length", "0.25"});
}

}  // namespace
}  // namespace loosefit::io
