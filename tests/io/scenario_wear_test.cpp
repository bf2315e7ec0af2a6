#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "loosefit/body/named_postures.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_writer.h"
#include "support/refused_scenario.h"
#include "support/scratch_folder.h"

namespace loosefit::io {
namespace {

using support::expect_refused;

TEST(ScenarioWear, WithoutTheSectionsThereIsOnePostureAndOneDonning) {
  const scenario::Scenario s = parse_scenario("", "case.toml");
  EXPECT_TRUE(s.postures.empty());
  EXPECT_EQ(s.donning.repeats, 1);
  EXPECT_EQ(scenario_toml(s).find("[postures]"), std::string::npos);
}

TEST(ScenarioWear, TheReferenceComesFirstAndIsThePostureOfTheMaps) {
  const scenario::Scenario s = parse_scenario(
      "[postures]\nlist = [\"slouch\", \"arms-forward\", \"a-pose\"]\nreference = \"a-pose\"\n"
      "[donning]\n[simulation]\nseed = 7\n",
      "case.toml");
  EXPECT_EQ(s.postures, (std::vector<std::string>{"a-pose", "slouch", "arms-forward"}));
  EXPECT_EQ(s.body.posture, body::named_posture("a-pose"));
  EXPECT_EQ(s.donning.repeats, 4);
  EXPECT_EQ(s.donning.seed, 7u);
  const scenario::Scenario again = parse_scenario(scenario_toml(s), "again.toml");
  EXPECT_EQ(again.postures, s.postures);
  EXPECT_EQ(again.body.posture, s.body.posture);
  EXPECT_EQ(again.donning.twist, s.donning.twist);
  EXPECT_EQ(scenario_toml(again), scenario_toml(s));
}

TEST(ScenarioWear, MovementsAreMadeUnlessSwitchedOffAndAskForNoRepeats) {
  EXPECT_EQ(parse_scenario("", "case.toml").donning.movements,
            (std::vector<std::string>{"arm-raise", "breath", "hem-pull", "fidget"}));
  const scenario::Scenario none = parse_scenario("[donning]\nmovements = []\n", "case.toml");
  EXPECT_TRUE(none.donning.movements.empty());
  EXPECT_EQ(none.donning.repeats, 1);
  const scenario::Scenario again = parse_scenario(scenario_toml(none), "again.toml");
  EXPECT_TRUE(again.donning.movements.empty());
  EXPECT_EQ(again.donning.repeats, 1);
  const scenario::Scenario own = parse_scenario(
      "[donning]\nmovements = [\"breath\", \"hem-pull\"]\nmovement_spread = 0.1\n", "case.toml");
  EXPECT_EQ(own.donning.movements, (std::vector<std::string>{"breath", "hem-pull"}));
  EXPECT_EQ(own.donning.movement_spread, 0.1);
  EXPECT_EQ(own.donning.repeats, 4);
  EXPECT_EQ(scenario_toml(parse_scenario(scenario_toml(own), "again.toml")), scenario_toml(own));
}

TEST(ScenarioWear, ADrawnFirstDonningAsksForNoRepeats) {
  const scenario::Scenario s =
      parse_scenario("[donning]\nfirst = \"drawn\"\nseed = 5\n", "case.toml");
  EXPECT_TRUE(s.donning.first_drawn);
  EXPECT_EQ(s.donning.repeats, 1);
  const scenario::Scenario again = parse_scenario(scenario_toml(s), "again.toml");
  EXPECT_TRUE(again.donning.first_drawn);
  EXPECT_EQ(again.donning.repeats, 1);
  EXPECT_EQ(again.donning.seed, 5u);
  // Addresses of cases of studies hang on this text.
  EXPECT_EQ(scenario_toml(parse_scenario("[donning]\nrepeats = 2\n", "case.toml")).find("first ="),
            std::string::npos);
  EXPECT_EQ(scenario_toml(again), scenario_toml(s));
  EXPECT_EQ(
      parse_scenario("[donning]\nfirst = \"drawn\"\nrepeats = 3\n", "case.toml").donning.repeats,
      3);
  EXPECT_EQ(parse_scenario("[donning]\nfirst = \"undisturbed\"\n", "case.toml").donning.repeats, 4);
}

TEST(ScenarioWear, AScanKeepsItsPostureUnlessOneIsAskedFor) {
  const support::ScratchFolder scratch;
  const auto file = scratch / "scan-posture.obj";
  std::ofstream(file) << "v 0 0 0\n";
  const std::string body = "[body]\nfile = \"" + file.string() + "\"\n";
  EXPECT_TRUE(parse_scenario(body, "case.toml").body.as_scanned);
  for (const std::string& more : {std::string("posture = \"sitting\"\n"),
                                  std::string("[postures]\nlist = [\"sitting\", \"a-pose\"]\n")}) {
    const scenario::Scenario s = parse_scenario(body + more, "case.toml");
    EXPECT_FALSE(s.body.as_scanned) << more;
    EXPECT_EQ(s.body.posture, body::named_posture("sitting")) << more;
    const scenario::Scenario again = parse_scenario(scenario_toml(s), "again.toml");
    EXPECT_EQ(again.body.posture, s.body.posture);
    EXPECT_FALSE(again.body.as_scanned);
    EXPECT_EQ(again.postures, s.postures);
    EXPECT_EQ(scenario_toml(again), scenario_toml(s));
  }
  expect_refused(body + "dress_posture = \"a-pose\"\n", {"body.dress_posture", "beside posture"});
  expect_refused(body + "height = 1.7\n", {"body.height", "brings its own size"});
}

TEST(ScenarioWear, EveryNamedPostureReadsBackFromTheResolvedText) {
  for (const auto& [name, posture] : body::named_postures()) {
    const scenario::Scenario s =
        parse_scenario("[body]\nposture = \"" + name + "\"\n", "case.toml");
    EXPECT_EQ(parse_scenario(scenario_toml(s), "again.toml").body.posture, posture) << name;
  }
}

TEST(ScenarioWear, OddInputIsRefusedByName) {
  expect_refused("[postures]\nlist = [\"standing\", \"siting\"]", {"postures.list", "sitting"});
  expect_refused("[postures]\nlist = [\"standing\", \"standing\"]", {"postures.list", "twice"});
  expect_refused("[postures]\nlist = []", {"postures.list", "at least one"});
  expect_refused("[postures]\nreference = \"standing\"", {"postures.reference"});
  expect_refused("[postures]\nlist = [\"standing\"]\nreference = \"slouch\"",
                 {"postures.reference"});
  expect_refused("[postures]\nlist = \"standing\"", {"postures.list", "array"});
  expect_refused("[postures]\nlst = [\"standing\"]", {"postures.lst", "list"});
  expect_refused("[body]\nposture = \"sitting\"\n[postures]\nlist = [\"standing\"]",
                 {"body.posture", "standing"});
  expect_refused("[donning]\nrepeats = 0", {"donning.repeats"});
  expect_refused("[donning]\nshift = -0.01", {"donning.shift"});
  expect_refused("[donning]\nshift = 10", {"donning.shift", "metres"});
  expect_refused("[donning]\ntwist_deg = -1", {"donning.twist_deg"});
  expect_refused("[donning]\nfriction_spread = -0.1", {"donning.friction_spread"});
  expect_refused("[donning]\nrepeats = 2\n[simulation]\nrepeats = 2",
                 {"donning.repeats", "simulation.repeats"});
  expect_refused("[donning]\nfirst = \"drawn\"\n[simulation]\nrepeats = 2",
                 {"donning.first", "simulation.repeats"});
  expect_refused("[donning]\nfirst = \"tossed\"", {"donning.first", "drawn"});
  expect_refused("[donning]\nmovements = [\"jump\"]", {"donning.movements", "hem-pull"});
  expect_refused("[donning]\nmovements = \"breath\"", {"donning.movements", "array"});
  expect_refused("[donning]\nmovement_spread = 2", {"donning.movement_spread"});
  expect_refused("donning = 4", {"donning"});
}

}  // namespace
}  // namespace loosefit::io
