#include "loosefit/validate/worn_drapes.h"

#include <gtest/gtest.h>

namespace loosefit::validate {
namespace {

// Garments of benchmarks are judged as wearers have them, not as putting on leaves them.
TEST(WornScenario, IsWornInByTheUsualMovements) {
  const scenario::Scenario s =
      worn_scenario("sex = \"male\"\nheight = 1.80", "fit = { chest = 0.12, hip = 0.12 }", 0.02, 3);
  EXPECT_EQ(s.donning.movements, scenario::ScenarioDonning{}.movements);
  EXPECT_FALSE(s.donning.movements.empty());
  EXPECT_EQ(s.donning.repeats, 3);
  EXPECT_DOUBLE_EQ(s.simulation.edge_length, 0.02);
}

TEST(WornScenario, TakesAChildAndASize) {
  const scenario::Scenario s = worn_scenario(
      "sex = 0.4  # a child before puberty\nage = 10\nheight = 1.40\n"
      "measurements = { chest = 0.63, waist = 0.55, hip = 0.68 }",
      "size = \"child-142\"", 0.014, 4);
  EXPECT_DOUBLE_EQ(s.body.sex, 0.4);
  EXPECT_DOUBLE_EQ(s.body.measurements.at("waist"), 0.55);
  EXPECT_EQ(s.studied().spec.size, "child-142");
}

}  // namespace
}  // namespace loosefit::validate
