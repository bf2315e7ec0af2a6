#include "loosefit/study/study_data.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "loosefit/io/text_file.h"
#include "loosefit/study/analysis.h"
#include "loosefit/study/gallery.h"
#include "support/study_on_disk.h"

namespace loosefit::study {
namespace {

// An axis that changes nothing gives each scenario two numbers; it runs once.
TEST_F(StudyOnDisk, WhatOneScenarioOfSeveralNumbersTookCountsOnce) {
  plan = make_plan(parse_study_file(
      kStudy + std::string("[scenario.donning]\nrepeats = 1\n[[axis]]\nname = \"idle\"\n"
                           "key = \"donning.shift\"\nvalues = [0.01, 0.02]\n"),
      "x.toml"));
  ASSERT_EQ(same_as_others(plan), 12);
  const StudyFolder folder = planned("a");
  const std::string open = plan.cases.front().address;
  std::set<std::string> ran;
  for (const PlannedCase& one : plan.cases) {
    if (one.address == open || !ran.insert(one.address).second) continue;
    finish(folder, one);
  }
  const FolderState state = folder.state(folder.read_plan());
  EXPECT_EQ(state.open.size(), 1u);
  EXPECT_EQ(state.open_cases, 2);
  EXPECT_EQ(state.open_cases + state.done + state.sealed + state.failed, 24);
  const StudyData data = read_study_data(folder);
  EXPECT_EQ(data.done, 22);
  EXPECT_DOUBLE_EQ(data.core_seconds, 11 * 12.5);
}

// A limit that hangs on one of four people says so.
TEST_F(StudyOnDisk, TheHeadlineSaysHowManyAreRatedAtTheFitThatSetsTheLimit) {
  const StudyFolder folder = planned("a");
  const auto headline = [&](int rated_at_second) {
    for (const PlannedCase& one : plan.cases) {
      const bool is_rated = one.levels[1] != 1 || one.levels[0] < rated_at_second;
      CaseRecord record = made_up(one.address, one.levels[1] < 2 ? 0.9 : 0.1);
      if (!is_rated) record.samples[0].score = record.samples[0].margin = kNotKnown;
      write_whole(folder.result_file(one.address), record_json(record));
    }
    return headlines(analyse(read_study_data(folder))).front();
  };
  EXPECT_NE(headline(1).find(" (rated there: 1 of 4)"), std::string::npos) << headline(1);
  EXPECT_EQ(headline(4).find("rated there"), std::string::npos) << headline(4);
}

// Four people at three drawn fits: a level with some people of one fit would be of other people.
TEST_F(StudyOnDisk, LevelsOfADrawnLoosenessNeverPartPeopleOfOneFit) {
  for (const int count : {2, 3, 7, 12}) {
    plan = make_plan(parse_study_file(
        "[study]\nname = \"x\"\nmodalities = [\"imu-uncalibrated\"]\n"
        "[[axis]]\nname = \"person\"\npeople = { statistics = \"ansur-2012\", count = 4 }\n"
        "[[axis]]\nname = \"fit\"\nkey = \"garment.fit.chest\"\nrange = [0.0, 0.3]\ncount = " +
            std::to_string(count) + "\n",
        "x.toml"));
    const StudyData data = read_study_data(planned(std::to_string(count)));
    std::map<int, std::set<int>> fits_of_level, people_of_level, levels_of_fit;
    for (std::size_t c = 0; c < plan.cases.size(); ++c) {
      const int level = data.level_of_case[c];
      people_of_level[level].insert(plan.cases[c].levels[0]);
      fits_of_level[level].insert(plan.cases[c].levels[1]);
      levels_of_fit[plan.cases[c].levels[1]].insert(level);
    }
    EXPECT_EQ(people_of_level.size(), data.level_bgm.size());
    EXPECT_EQ(data.level_bgm.size(), std::min<std::size_t>(count, 5));
    for (const auto& [level, people] : people_of_level) EXPECT_EQ(people.size(), 4u) << level;
    for (const auto& [fit, levels] : levels_of_fit) EXPECT_EQ(levels.size(), 1u) << fit;
    EXPECT_TRUE(std::ranges::is_sorted(data.level_bgm));
  }
}

TEST_F(StudyOnDisk, CorrelationsCountThoseOfWhomBothAreKnown) {
  fs::create_directories(base);
  std::string people = "name,height,waist\n";
  for (int p = 0; p < 9; ++p)
    people += fmt::format("p{},{},{}\n", p, 1.6 + 0.02 * p,
                          p < 4 ? fmt::format("{}", 0.70 + 0.02 * p) : "");
  io::write_text_file((base / "people.csv").string(), people);
  plan = make_plan(parse_study_file(
      "[study]\nname = \"x\"\nmodalities = [\"imu-uncalibrated\"]\n"
      "[[axis]]\nname = \"person\"\npeople = { file = \"people.csv\" }\n"
      "[[axis]]\nname = \"fit\"\nkey = \"garment.fit.chest\"\nvalues = [0.0, 0.1, 0.2]\n",
      (base / "x.toml").string()));
  std::map<std::string, int> units;
  for (const ModalityAnalysis& of : analyse(read_study_data(finished("a"))).modalities)
    for (const Sensitivity& row : of.sensitivity)
      if (!row.main_effect) units[row.input] = row.units;
  EXPECT_EQ(units.at("person.height"), 9);
  EXPECT_EQ(units.at("person.waist"), 4);
}

TEST_F(StudyOnDisk, AKeptOutputThatCannotBeReadCostsTheGalleryAlone) {
  const StudyFolder folder = finished("a");
  const fs::path output = folder.case_folder(plan.cases.front().address) / "output";
  fs::create_directories(output);
  io::write_text_file((output / "drape.vtp").string(), "half a fi");
  Progress silent;
  const Gallery gallery = make_gallery(folder, folder.read_plan(), silent);
  EXPECT_TRUE(gallery.png.empty());
  EXPECT_FALSE(gallery.why.empty());
}

}  // namespace
}  // namespace loosefit::study
