#include "loosefit/report/run_into_folder.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scorecard_file.h"
#include "loosefit/io/text_file.h"
#include "loosefit/report/rank_runs.h"
#include "loosefit/report/write_output.h"
#include "support/scratch_folder.h"

namespace loosefit::report {
namespace {

namespace fs = std::filesystem;

class RunIntoFolder : public ::testing::Test {
 protected:
  bool has(const std::string& file) const { return fs::exists(folder_ / file); }
  std::string text(const char* file) const {
    return io::read_text_file((folder_ / file).string(), 50000000);
  }
  const support::ScratchFolder scratch_;
  const fs::path folder_ = scratch_ / "run";
  Progress silent_;
  // A shirt as it is put on, without time to settle.
  scenario::Scenario scenario_ = io::parse_scenario(
      "[[site]]\nname = \"spine\"\nlandmark = \"mid_back\"\n"
      "[output]\npreset_sites = false\nmaps = [\"distance\"]\n"
      "[simulation]\nedge_length = 0.05\ntime_budget = 0.1\n",
      "case.toml");
};

TEST_F(RunIntoFolder, DoesAllThatTheCommandsDoByFunctionCallsAlone) {
  const pipeline::RunOptions options{.allow_unsettled = true};
  const FolderOutput run = run_into_folder(scenario_, folder_, options, false, silent_);
  EXPECT_FALSE(run.result.certificate().holds());
  EXPECT_EQ(run.result.sites.size(), 1u);
  EXPECT_EQ(run.result.seconds.back().stage, "report");
  for (const std::string& file : planned_files(scenario_, {.log = true, .pictures = false}))
    EXPECT_TRUE(has(file)) << file;
  EXPECT_NE(text("log.jsonl").find("not settled"), std::string::npos);
  EXPECT_EQ(text("sites.csv").find("gap_mm_map"), std::string::npos) << "no such map yet";

  // Other maps of the same drape.
  RedoOptions redo;
  redo.maps = {"gap"};
  EXPECT_THROW(redo_in_folder(folder_, redo, silent_), Error) << "it is not settled";
  redo.allow_unsettled = true;
  const FolderOutput again = redo_in_folder(folder_, redo, silent_);
  EXPECT_EQ(again.result.studied().drape.positions.size(),
            run.result.studied().drape.positions.size());
  EXPECT_EQ(again.set_aside, "");
  EXPECT_NE(text("sites.csv").find("gap_mm"), std::string::npos);

  // A ranking beside it; its reader has it before the files are there.
  RankRuns asked{.inputs = {folder_.string()}, .wish = {}, .allow_unsettled = true, .output = {}};
  asked.wish.scorecard = io::load_scorecard("imu-inclination");
  asked.wish.partial = true;
  int told = 0;
  const RankedRuns ranked = rank_runs(asked, silent_, [&](const placement::RankingTable& table) {
    told += static_cast<int>(table.sites.size());
    EXPECT_FALSE(has("ranking-imu-inclination.csv"));
  });
  EXPECT_EQ(told, 1);
  EXPECT_FALSE(ranked.all_hold);
  EXPECT_EQ(ranked.folder, folder_.string());
  EXPECT_TRUE(has("ranking-imu-inclination.csv"));
  asked.inputs.push_back(folder_.string() + "/");
  EXPECT_THROW(rank_runs(asked, silent_), InvalidInput) << "the same run twice";
}

TEST_F(RunIntoFolder, ADrapeAloneHasNoSitesAndNoReport) {
  const pipeline::RunOptions options{.only_drape = true};
  const FolderOutput run = run_into_folder(scenario_, folder_, options, true, silent_);
  EXPECT_TRUE(run.result.sealed());
  EXPECT_FALSE(run.ranking);
  EXPECT_TRUE(has("drape.vtp"));
  EXPECT_FALSE(has("sites.csv"));
  EXPECT_FALSE(has("report.html"));
}

}  // namespace
}  // namespace loosefit::report
