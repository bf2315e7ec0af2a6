#include "loosefit/study/controls.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <random>

#include "loosefit/io/text_file.h"
#include "loosefit/study/store.h"
#include "loosefit/study/study_data.h"
#include "loosefit/study/study_page.h"
#include "support/study_on_disk.h"

namespace loosefit::study {
namespace {

TEST(Controls, AreOneInTwentyByTheAddressAloneAndAtLeastOne) {
  std::vector<std::string> addresses;
  for (unsigned i = 0; i < 4000; ++i)
    addresses.push_back(fmt::format("{:06x}", (i * 2654435761u) >> 8));
  const std::vector<std::string> all = control_addresses(addresses);
  EXPECT_NEAR(double(all.size()), 200, 50);
  // Those of a part are among those of the whole.
  const std::vector<std::string> part(addresses.begin(), addresses.begin() + 1000);
  for (const std::string& address : control_addresses(part))
    EXPECT_NE(std::find(all.begin(), all.end(), address), all.end());
  using Addresses = std::vector<std::string>;
  EXPECT_EQ(control_addresses(Addresses{"00000b", "000003", "000007"}), Addresses{"000003"});
  EXPECT_TRUE(control_addresses(Addresses{}).empty());
}

CaseRecord record(double gap, double score) {
  CaseRecord r;
  r.status = CaseStatus::done;
  for (int donning = 1; donning <= 2; ++donning) {
    SampleRecord sample;
    sample.modality = "imu";
    sample.site = "t3";
    sample.donning = donning;
    sample.score = score;
    sample.metrics = {{"gap_mm", gap * donning}};
    r.samples.push_back(sample);
  }
  return r;
}

TEST(Controls, TellTheGreatestChange) {
  const Control control = compared(record(1.0, 0.5), record(1.01, 0.48));
  EXPECT_TRUE(control.ran);
  EXPECT_NEAR(control.largest.at("gap_mm"), 0.02, 1e-12);
  EXPECT_NEAR(control.largest.at("score"), 0.02, 1e-12);
  CaseRecord sealed;
  sealed.status = CaseStatus::sealed;
  sealed.reason = "not settled: time budget";
  const Control bad = compared(record(1, 1), sealed);
  EXPECT_EQ(bad.failed, "not settled: time budget");
  ControlSummary summary;
  add(control, summary);
  add(bad, summary);
  add(Control{}, summary);
  EXPECT_EQ(summary.cases, 2);
  EXPECT_EQ(summary.failed, 1);
  EXPECT_NEAR(summary.largest.at("gap_mm"), 0.02, 1e-12);
}

// From 179° to −179° it is 2°, and a rate per degree is no angle.
TEST(Controls, TurnAnglesTheShorterWay) {
  const auto with = [](double twist, double gain, double gap) {
    CaseRecord r = record(0, 0.5);
    r.samples.resize(1);
    r.samples[0].metrics = {
        {"twist_deg", twist}, {"line_gain_percent_per_deg", gain}, {"gap_mm", gap}};
    return r;
  };
  const Control control = compared(with(179, 400, 350), with(-179, 0, 0));
  EXPECT_NEAR(control.largest.at("twist_deg"), 2, 1e-12);
  EXPECT_NEAR(control.largest.at("line_gain_percent_per_deg"), 400, 1e-12);
  EXPECT_NEAR(control.largest.at("gap_mm"), 350, 1e-12);
  EXPECT_NEAR(compared(with(-90, 0, 0), with(90, 0, 0)).largest.at("twist_deg"), 180, 1e-12);
  EXPECT_NEAR(compared(with(10, 0, 0), with(-20, 0, 0)).largest.at("twist_deg"), 30, 1e-12);
  EXPECT_NEAR(compared(with(0, 0, 0), with(725, 0, 0)).largest.at("twist_deg"), 5, 1e-12);
}

// A score that is there at one grade alone has no difference, and is the greatest change of all.
TEST(Controls, CountSamplesThatLoseOrGainTheirScore) {
  const CaseRecord rated = record(1, 0.5);  // two donnings
  CaseRecord half = rated, first = rated, elsewhere = rated;
  half.samples[1].score = kNotKnown;
  first.samples.resize(1);
  for (SampleRecord& sample : elsewhere.samples) sample.site = "l5";
  const auto expect = [](const CaseRecord& b, const CaseRecord& a, const ScoreChanges& expected) {
    const Control control = compared(b, a);
    ASSERT_TRUE(control.scores);
    EXPECT_EQ(control.scores->kept, expected.kept);
    EXPECT_EQ(control.scores->lost, expected.lost);
    EXPECT_EQ(control.scores->gained, expected.gained);
  };
  expect(rated, rated, {2, 0, 0});
  expect(rated, half, {1, 1, 0});
  expect(half, rated, {1, 0, 1});
  expect(half, half, {1, 0, 0});
  expect(rated, first, {1, 1, 0});
  expect(first, rated, {1, 0, 1});
  expect(rated, elsewhere, {0, 2, 2});
  CaseRecord sealed;
  sealed.status = CaseStatus::sealed;
  EXPECT_FALSE(compared(rated, sealed).scores) << "it is told as failed";
  ControlSummary summary;
  for (const CaseRecord& a : {sealed, half, first, elsewhere}) add(compared(rated, a), summary);
  EXPECT_EQ(summary.cases, 4);
  EXPECT_EQ(summary.counted, 3);
  EXPECT_EQ(summary.scores.kept, 2);
  EXPECT_EQ(summary.scores.lost, 4);
  EXPECT_EQ(summary.scores.gained, 2);
}

TEST(Controls, AreReadAsTheyWereWritten) {
  CaseRecord one = made_up("ab12", 0.5);
  one.control = {true, "", {{"slip_mm", 0.25}}, ScoreChanges{7, 2, 1}};
  const Control read = parse_record(record_json(one), "x").control;
  ASSERT_TRUE(read.scores);
  EXPECT_EQ(read.scores->kept, 7);
  EXPECT_EQ(read.scores->lost, 2);
  EXPECT_EQ(read.scores->gained, 1);
  // An earlier program did not count.
  one.control.scores.reset();
  EXPECT_FALSE(parse_record(record_json(one), "x").control.scores);
}

/// kStudy, content with grade B, with other people and fits.
Plan plan_with(int seed, const std::string& fits) {
  std::string text = kStudy;
  text.replace(text.find("modalities"), 0, "seed = " + std::to_string(seed) + "\n");
  text.replace(text.find("[0.0, 0.1, 0.2]"), 15, fits);
  return make_plan(
      parse_study_file(text + "[scenario.simulation]\ncertificate = \"B\"\n", "x.toml"));
}

struct ControlsOfAStudy : StudyOnDisk {
  /// What a runner and its workers do, in an order of their own; returns the content of the
  /// database.
  static std::string run(const StudyFolder& folder, const Plan& plan, unsigned order = 0) {
    fs::create_directories(folder.path().parent_path());
    folder.write_plan(plan);
    const FolderPlan read = folder.read_plan();
    collect(folder, read);
    std::vector<std::string> open = folder.state(read).open;
    std::shuffle(open.begin(), open.end(), std::mt19937(order));
    for (const std::string& address : open) {
      CaseRecord one = folder.record(address).value_or(made_up(address, 0.5));
      if (read.controls.count(address)) one.control = {true, "", {{"slip_mm", 0.25}}};
      write_whole(folder.result_file(address), record_json(one));
      Store(folder.database()).put(read, *folder.record(read, address));
    }
    EXPECT_TRUE(folder.state(read).open.empty());
    return content_sha256(folder.database());
  }
  static std::set<std::string> chosen(const Plan& plan) {
    const std::vector<std::string> all = control_addresses(plan);
    return {all.begin(), all.end()};
  }
};

// A plan that grows may get its first control by address, or a lesser least one: cases that have
// run are then controls and were none, or the other way round.
TEST_F(ControlsOfAStudy, HangOnThePlanAloneAndNotOnWhatHasRunBefore) {
  const std::string few = "[0.0, 0.1]", more = "[0.0, 0.1, 0.2]";
  int moved = 0;
  for (int seed = 1; seed <= 12; ++seed) {
    const Plan small = plan_with(seed, few), large = plan_with(seed, more);
    const fs::path here = base / std::to_string(seed);
    const std::string small_alone = run(StudyFolder(here / "small"), small);
    const std::string large_alone = run(StudyFolder(here / "large"), large);
    const StudyFolder grown(here / "grown");
    EXPECT_EQ(run(grown, small, 1), small_alone);
    EXPECT_EQ(run(grown, large, 2), large_alone) << "grown by a level, seed " << seed;
    EXPECT_EQ(run(grown, small, 3), small_alone) << "and cut again, seed " << seed;
    EXPECT_EQ(read_study_data(grown).controls.cases, int(chosen(small).size()));
    std::set<std::string> of_small;
    for (const PlannedCase& one : small.cases) of_small.insert(one.address);
    std::set<std::string> kept;
    for (const std::string& address : chosen(large))
      if (of_small.count(address)) kept.insert(address);
    moved += kept != chosen(small);
  }
  EXPECT_GT(moved, 0) << "no plan of these tells anything";
}

TEST_F(ControlsOfAStudy, DoNotHangOnTheOrderOfLevels) {
  for (int seed = 1; seed <= 5; ++seed)
    EXPECT_EQ(chosen(plan_with(seed, "[0.0, 0.1, 0.2]")),
              chosen(plan_with(seed, "[0.2, 0.0, 0.1]")));
}

TEST_F(ControlsOfAStudy, OfAnEarlierProgramStandBesideItsPlan) {
  plan = plan_with(1, "[0.0, 0.1]");
  const StudyFolder folder = planned("a");
  const std::string file = (folder.path() / "plan.json").string();
  nlohmann::json json = nlohmann::json::parse(io::read_text_file(file, 1000000));
  json.erase("controls");
  io::write_text_file(file, json.dump());
  EXPECT_TRUE(folder.read_plan().controls.empty());
  std::string lines;
  for (const std::string& address : control_addresses(plan)) lines += address + "\n";
  io::write_text_file((folder.path() / "controls.txt").string(), lines);
  EXPECT_EQ(folder.read_plan().controls, chosen(plan));
}

TEST_F(ControlsOfAStudy, AreOpenUntilTheyHaveGoneOnToGradeA) {
  plan = plan_with(1, "[0.0, 0.1]");
  const StudyFolder folder = planned("a");
  const FolderPlan read = folder.read_plan();
  ASSERT_EQ(read.controls, chosen(plan));
  for (const PlannedCase& one : plan.cases) finish(folder, one);
  EXPECT_EQ(folder.state(read).open.size(), read.controls.size());
  const std::string control = *read.controls.begin();
  EXPECT_TRUE(folder.record(control)) << "what has run stays";
  EXPECT_FALSE(folder.record(read, control));
  CaseRecord failed;
  failed.address = control;
  write_whole(folder.result_file(control), record_json(failed));
  EXPECT_TRUE(folder.record(read, control)) << "a case that failed goes no further";
}

TEST_F(ControlsOfAStudy, TellOfLostScoresInDatabaseAndPage) {
  plan = plan_with(1, "[0.0, 0.1]");
  const StudyFolder folder = planned("a");
  const FolderPlan read = folder.read_plan();
  for (const PlannedCase& one : plan.cases) {
    CaseRecord record = made_up(one.address, 0.5);
    record.grade = "B";
    if (read.controls.count(one.address))
      record.control = {true, "", {{"slip_mm", 0.25}}, ScoreChanges{7, 2, 1}};
    write_whole(folder.result_file(one.address), record_json(record));
  }
  collect(folder, read);
  const auto rows = [&] {
    const Database database(folder.database(), Database::Mode::read);
    std::vector<std::array<int, 3>> all;
    for (Statement row = database.prepare("SELECT kept, lost, gained FROM control_scores");
         row.step();)
      all.push_back({row.integer(0), row.integer(1), row.integer(2)});
    return all;
  };
  const std::vector<std::array<int, 3>> all(read.controls.size(), {7, 2, 1});
  EXPECT_EQ(rows(), all);
  // The database of an earlier program gets the table.
  Database(folder.database(), Database::Mode::write).run("DROP TABLE control_scores");
  collect(folder, read);
  EXPECT_EQ(rows(), all);
  const int n = static_cast<int>(read.controls.size());
  StudyAnalysis analysis = analyse(read_study_data(folder));
  const auto sentence = [&](int controls) {
    return fmt::format(
        "{} of {} controls count their scores: of their samples {} have a score at both grades, {} "
        "lose it by going on to A and {} gain one",
        n, controls, 7 * n, 2 * n, n);
  };
  EXPECT_NE(study_html(analysis).find(sentence(n)), std::string::npos) << study_html(analysis);
  // Others failed, or were run by an earlier program.
  analysis.data.controls.cases += 2;
  EXPECT_NE(study_html(analysis).find(sentence(n + 2)), std::string::npos) << study_html(analysis);
  // A case that is no control any more loses them.
  FolderPlan without = read;
  without.controls.clear();
  Store(folder.database()).put_plan(without);
  EXPECT_TRUE(rows().empty());
}

TEST_F(ControlsOfAStudy, ThatFailedRunAgainWhenAskedAndTheirCasesDoNot) {
  plan = plan_with(1, "[0.0, 0.1]");
  const StudyFolder folder = planned("a");
  const FolderPlan read = folder.read_plan();
  const std::string control = *read.controls.begin();
  for (const PlannedCase& one : plan.cases) {
    CaseRecord record = made_up(one.address, 0.5);
    if (one.address == control) record.control = {true, "the program crashed", {}};
    write_whole(folder.result_file(one.address), record_json(record));
  }
  EXPECT_TRUE(folder.state(read).open.empty());
  EXPECT_EQ(folder.forget_failed(read), 1);
  EXPECT_EQ(folder.state(read).open, std::vector<std::string>{control});
  ASSERT_TRUE(folder.record(control)) << "the case itself stays";
  EXPECT_FALSE(folder.record(control)->control.ran);
  EXPECT_EQ(folder.forget_failed(read), 0);
}

}  // namespace
}  // namespace loosefit::study
