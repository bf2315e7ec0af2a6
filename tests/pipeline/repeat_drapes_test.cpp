#include "loosefit/pipeline/repeat_drapes.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "loosefit/base/error.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/text_file.h"
#include "loosefit/pipeline/case_files.h"
#include "loosefit/pipeline/case_warnings.h"
#include "loosefit/pipeline/load_case.h"
#include "loosefit/pipeline/run_case.h"
#include "loosefit/pipeline/summary.h"
#include "support/scratch_folder.h"

namespace loosefit::pipeline {
namespace {

/// Three drapes of a tank top on a mesh that settles in a second.
CaseResult repeated(const std::string& simulation, const std::string& more = "") {
  const std::string text =
      more +
      "[garment]\npattern = \"tank-top\"\n[body]\nposture = \"a-pose\"\n"
      "[donning]\nmovements = [\"breath\"]\n[[site]]\nname = \"mid\"\nlandmark = \"mid_back\"\n"
      "[output]\npreset_sites = false\nmaps = [\"distance\"]\n"
      "[simulation]\nedge_length = 0.05\nrepeats = 3\n" +
      simulation;
  Progress silent;
  return run_case(io::parse_scenario(text, "case.toml"), silent);
}

/// What its summary.json tells of settling, place by place.
nlohmann::json settle_section(const CaseResult& result) {
  return nlohmann::json::parse(summary_json(result))["settle"].flatten();
}

class RepeatDrapes : public ::testing::Test {
 protected:
  void store(const CaseResult& result) const {
    write_case_files(folder_, result);
    write_summary_file(folder_, result);
  }
  /// As `loosefit map` does.
  CaseResult read_again() const {
    Progress silent;
    return remap_case(load_case(folder_, silent), false, silent);
  }
  void replace_in(const char* file, const std::string& from, const std::string& to) const {
    std::string text = io::read_text_file((folder_ / file).string(), 50000000);
    ASSERT_NE(text.find(from), std::string::npos) << text;
    text.replace(text.find(from), from.size(), to);
    io::write_text_file((folder_ / file).string(), text);
  }
  const support::ScratchFolder folder_;
};

TEST_F(RepeatDrapes, SameSpreadSideBySideAsOneByOneAndAfterReadingTheRunAgain) {
  const CaseResult alone = repeated("threads = 1\n");
  CaseResult beside;
  tbb::task_arena(2).execute([&] { beside = repeated("threads = 2\n"); });
  for (const char* key : {"maps.distance_mm.area_mean", "sites.mid.distance_mm"}) {
    ASSERT_TRUE(alone.repeats.spread.contains(key)) << key;
    EXPECT_EQ(alone.repeats.spread.at(key).count, 3);
    EXPECT_GT(alone.repeats.spread.at(key).deviation, 0) << key;
    EXPECT_EQ(alone.repeats.spread.at(key).mean, beside.repeats.spread.at(key).mean) << key;
    EXPECT_EQ(alone.repeats.spread.at(key).deviation, beside.repeats.spread.at(key).deviation)
        << key;
  }
  store(beside);
  const CaseResult again = read_again();
  ASSERT_EQ(again.repeats.spread.size(), beside.repeats.spread.size());
  for (const auto& [key, spread] : beside.repeats.spread) {
    EXPECT_EQ(again.repeats.spread.at(key).count, spread.count) << key;
    EXPECT_EQ(again.repeats.spread.at(key).mean, spread.mean) << key;
    EXPECT_EQ(again.repeats.spread.at(key).deviation, spread.deviation) << key;
  }
  EXPECT_EQ(again.warnings, beside.warnings);
  const nlohmann::json told = settle_section(beside), recalled = settle_section(again);
  ASSERT_EQ(recalled.size(), told.size());
  EXPECT_TRUE(told.contains("/recoveries/0/name"));
  for (const auto& [key, value] : told.items())
    if (value.is_number())
      EXPECT_NEAR(recalled[key].get<double>(), value.get<double>(), 1e-12) << key;
    else
      EXPECT_EQ(recalled[key], value) << key;
  // Damage is refused before anything is overwritten.
  replace_in("summary.json", "\"repeats\": {", "\"repeats\": {\"maps.odd\": null, ");
  EXPECT_THROW(read_again(), InvalidInput);
  io::write_text_file((folder_ / "summary.json").string(), "{");
  EXPECT_THROW(read_again(), InvalidInput);
}

TEST_F(RepeatDrapes, OnlyWhatEveryDrapeHasIsSpread) {
  CaseResult result = repeated("", "[postures]\nlist = [\"a-pose\", \"forward-bend-15\"]\n");
  EXPECT_FALSE(result.repeats.spread.contains("maps.slip_mm.area_mean")) << "of one drape alone";
  ASSERT_TRUE(result.repeats.spread.contains("maps.distance_mm.area_mean"));
  for (const auto& [key, spread] : result.repeats.spread) EXPECT_EQ(spread.count, 3) << key;

  const auto warns = [&](const std::string& of) {
    return std::ranges::any_of(case_warnings(result), [&](const std::string& warning) {
      return warning.find(of) != std::string::npos;
    });
  };
  result.scenario.simulation.start_perturbation = 0;
  EXPECT_FALSE(warns("repeats begin alike")) << "what movements draw differs";
  result.scenario.donning.movement_spread = 0;
  EXPECT_TRUE(warns("repeats begin alike"));
  EXPECT_FALSE(warns("has no skin under it"));
  result.sites.at(0).not_covering = "the cloth hangs 200 mm off the skin there";
  EXPECT_TRUE(warns("site mid has no skin under it: the cloth hangs 200 mm off"));
}

TEST_F(RepeatDrapes, SpreadsOfAScenarioThatHasChangedAreLeftOutWithAWarning) {
  const CaseResult result = repeated("");
  store(result);
  replace_in("scenario.toml", "mid_back", "lower_back");
  const CaseResult again = read_again();
  EXPECT_TRUE(again.repeats.spread.empty());
  EXPECT_EQ(again.warnings.size(), result.warnings.size() + 2);
  // A drape of other forces has no certificate.
  replace_in("scenario.toml", "gravity = 9.", "gravity = 8.");
  try {
    read_again();
    ADD_FAILURE() << "judged by the certificate of another drape";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place().key, "simulation") << error.what();
  }
  replace_in("scenario.toml", "gravity = 8.", "gravity = 9.");
  replace_in("scenario.toml", "areal_density = 0.", "areal_density = 0.0");
  try {
    read_again();
    ADD_FAILURE() << "judged by the certificate of another drape";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place().key, "material") << error.what();
  }
}

TEST_F(RepeatDrapes, DrapesThatDidNotSettleAreNamedAlsoWhenTheRunIsReadAgain) {
  CaseResult result = repeated("");
  const std::size_t of_the_drape = result.warnings.size();
  result.scenario.simulation.time_budget = 0.1;
  Progress silent;
  result.repeats = repeat_drapes(result, 2, silent);
  EXPECT_TRUE(result.repeats.spread.empty()) << "one drape has no spread";
  ASSERT_EQ(result.repeats.warnings.size(), 2u);
  EXPECT_NE(result.repeats.warnings[1].find("repeat 3 did not settle"), std::string::npos);
  store(result);
  const CaseResult again = read_again();
  EXPECT_EQ(again.repeats.warnings, result.repeats.warnings);
  EXPECT_EQ(again.warnings.size(), of_the_drape + 3);
}

}  // namespace
}  // namespace loosefit::pipeline
