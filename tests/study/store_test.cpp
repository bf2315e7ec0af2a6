#include "loosefit/study/store.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "loosefit/base/error.h"
#include "loosefit/io/text_file.h"
#include "loosefit/study/analysis.h"
#include "loosefit/study/compare.h"
#include "loosefit/study/gallery.h"
#include "loosefit/study/study_page.h"
#include "loosefit/study/worker_process.h"

// Records, folder and database, with results that are made up.
namespace loosefit::study {
namespace fs = std::filesystem;
namespace {

const char* const kStudy =
    "[study]\nname = \"x\"\nmodalities = [\"imu-uncalibrated\"]\n"
    "[[axis]]\nname = \"person\"\npeople = { statistics = \"ansur-2012\", count = 4 }\n"
    "[[axis]]\nname = \"fit\"\nkey = \"garment.fit.chest\"\nvalues = [0.0, 0.1, 0.2]\n";

CaseRecord made_up(const std::string& address, double score) {
  CaseRecord record;
  record.address = address;
  record.status = CaseStatus::done;
  record.residual = 0.1 / 3;
  record.drapes_asked = record.drapes_counted = 1;
  record.body = {{"chest", 0.9 + 1e-17}, {"odd", std::nan("")}};
  record.fit = {{"chest", 0.1}};
  record.garment = {{"uncomfortable_share", 0.0}};
  record.maps["distance_mm"] = {{"median", 3.25}};
  record.sites.push_back({"imu-uncalibrated", "scapula", "back", "back", 0.1, 0.2, 0, 0, 1, ""});
  SampleRecord sample;
  sample.modality = "imu-uncalibrated";
  sample.site = "scapula";
  sample.score = std::clamp(score, 0.0, 1.0);
  sample.margin = score;
  sample.limiting = "rotation_deg";
  sample.metrics = {{"rotation_deg", 10 - 5 * score}};
  record.samples.push_back(sample);
  record.versions = {{"loosefit", "0"}};
  record.execution = {12.5, 100, "somewhere"};
  return record;
}

struct StudyOnDisk : ::testing::Test {
  fs::path base =
      fs::temp_directory_path() / ("loosefit-study-" + std::to_string(getpid()) + "-" +
                                   ::testing::UnitTest::GetInstance()->current_test_info()->name());
  Plan plan = make_plan(parse_study_file(kStudy, "x.toml"));
  void SetUp() override { fs::remove_all(base); }
  void TearDown() override { fs::remove_all(base); }

  /// Score of a case: falls with the fit, rises with the person.
  static double score(const PlannedCase& one) {
    return 0.9 - 0.3 * one.levels[1] + 0.05 * one.levels[0];
  }
  StudyFolder planned(const std::string& name) const {
    const StudyFolder folder(base / name);
    fs::create_directories(base);
    folder.write_plan(plan);
    return folder;
  }
  void finish(const StudyFolder& folder, const PlannedCase& one) const {
    write_whole(folder.result_file(one.address), record_json(made_up(one.address, score(one))));
  }
  StudyFolder finished(const std::string& name) const {
    const StudyFolder folder = planned(name);
    for (const PlannedCase& one : plan.cases) finish(folder, one);
    return folder;
  }
};

TEST(CaseRecord, ReadsBackAsTheSameBits) {
  const CaseRecord record = made_up(std::string(64, 'a'), 0.1 + 0.2);
  const CaseRecord again = parse_record(record_json(record), "x");
  EXPECT_EQ(record_json(again), record_json(record));
  EXPECT_EQ(again.samples[0].margin, 0.1 + 0.2);
  EXPECT_EQ(again.residual, 0.1 / 3);
  EXPECT_TRUE(std::isnan(again.body.at("odd")));
}

TEST(CaseRecord, OfWhichAnythingIsMissingOrChangedDoesNotCount) {
  const std::string whole = record_json(made_up(std::string(64, 'a'), 0.5));
  for (std::size_t length = 0; length < whole.size(); length += 37)
    EXPECT_THROW(parse_record(whole.substr(0, length), "x"), InvalidInput) << length;
  for (std::size_t at = 0; at < whole.size(); at += 53) {
    std::string changed = whole;
    changed[at] = changed[at] == '7' ? '8' : '7';
    EXPECT_THROW(parse_record(changed, "x"), InvalidInput) << at;
  }
}

// As a runner leaves it that is killed while it writes, after each of its files in turn.
TEST_F(StudyOnDisk, APlanThatWasCutOffIsWrittenToItsEndAndNothingHalfWrittenStays) {
  const StudyFolder whole = planned("whole");
  const std::string first = plan.cases.front().address, last = plan.cases.back().address;
  const std::vector<fs::path> order = {whole.path() / "plan.json", whole.path() / "study.toml",
                                       whole.scenario_file(first), whole.scenario_file(last),
                                       whole.path() / "controls.txt"};
  for (std::size_t kept = 0; kept < order.size(); ++kept) {
    const StudyFolder cut(base / ("cut-" + std::to_string(kept)));
    for (std::size_t i = 0; i <= kept; ++i) {
      const fs::path file = cut.path() / fs::relative(order[i], whole.path());
      fs::create_directories(file.parent_path());
      if (i < kept)
        fs::copy_file(order[i], file);
      else
        io::write_text_file(
            (file.parent_path() / ("." + file.filename().string() + ".writing-7")).string(),
            "half");
    }
    cut.write_plan(plan);
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(cut.path())) {
      if (!entry.is_regular_file()) continue;
      ++files;
      const fs::path other = whole.path() / fs::relative(entry.path(), cut.path());
      ASSERT_TRUE(fs::exists(other)) << entry.path();
      EXPECT_EQ(io::read_text_file(entry.path().string(), 1000000),
                io::read_text_file(other.string(), 1000000));
    }
    EXPECT_EQ(files, static_cast<int>(plan.cases.size()) + 3);
  }
}

TEST_F(StudyOnDisk, CountsWholeResultsOnly) {
  const StudyFolder folder = planned("a");
  const FolderPlan read = folder.read_plan();
  EXPECT_EQ(folder.state(read).open.size(), 12u);
  finish(folder, plan.cases[0]);
  const std::string half = record_json(made_up(plan.cases[1].address, 1)).substr(0, 300);
  io::write_text_file(folder.result_file(plan.cases[1].address).string(), half);
  // A result under the address of another case.
  io::write_text_file(folder.result_file(plan.cases[2].address).string(),
                      record_json(made_up(plan.cases[3].address, 1)));
  EXPECT_EQ(folder.state(read).done, 1);
  EXPECT_EQ(folder.state(read).open.size(), 11u);
}

TEST_F(StudyOnDisk, PlanReadsBack) {
  const FolderPlan read = planned("a").read_plan();
  ASSERT_EQ(read.cases.size(), plan.cases.size());
  EXPECT_EQ(read.cases[7].address, plan.cases[7].address);
  EXPECT_EQ(read.axes[0].levels[2].inputs, plan.study.axes[0].levels[2].inputs);
  EXPECT_EQ(read.looseness, "fit");
  EXPECT_EQ(label(read, read.cases[4]), "person 2, fit 0.1");
}

TEST_F(StudyOnDisk, AForeignFolderIsLeftAlone) {
  fs::create_directories(base / "mine");
  io::write_text_file((base / "mine" / "notes.txt").string(), "keep");
  EXPECT_THROW(StudyFolder(base / "mine").write_plan(plan), InvalidInput);
  EXPECT_FALSE(fs::exists(base / "mine" / "cases"));
  EXPECT_THROW(StudyFolder(base / "mine").read_plan(), InvalidInput);
}

TEST_F(StudyOnDisk, ASecondRunnerIsToldWhoRuns) {
  const StudyFolder folder = planned("a");
  const StudyLock first(folder);
  try {
    const StudyLock second(folder);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("process " + std::to_string(getpid())),
              std::string::npos)
        << error.what();
  }
}

TEST_F(StudyOnDisk, DatabaseDoesNotDependOnTheOrder) {
  const StudyFolder forwards = finished("a");
  collect(forwards, forwards.read_plan());
  const StudyFolder backwards = planned("b");
  const FolderPlan read = backwards.read_plan();
  for (auto one = plan.cases.rbegin(); one != plan.cases.rend(); ++one) {
    finish(backwards, *one);
    collect(backwards, read);
  }
  EXPECT_EQ(content_sha256(forwards.database()), content_sha256(backwards.database()));
  // Another result is another content; where and how long it ran is not.
  CaseRecord moved = made_up(plan.cases[3].address, score(plan.cases[3]));
  moved.execution = {1, 2, "elsewhere"};
  Store(backwards.database()).put(read, moved);
  EXPECT_EQ(content_sha256(forwards.database()), content_sha256(backwards.database()));
  moved.samples[0].margin += 1e-15;
  Store(backwards.database()).put(read, moved);
  EXPECT_NE(content_sha256(forwards.database()), content_sha256(backwards.database()));
}

TEST_F(StudyOnDisk, DatabaseThatIsDamagedOrBehindIsMadeAnew) {
  const StudyFolder folder = finished("a");
  const FolderPlan read = folder.read_plan();
  collect(folder, read);
  const std::string content = content_sha256(folder.database());
  io::write_text_file(folder.database().string(), "this is no database, but long enough for one");
  collect(folder, read);
  EXPECT_EQ(content_sha256(folder.database()), content);
  fs::remove(folder.result_file(plan.cases[5].address));
  collect(folder, read);
  EXPECT_NE(content_sha256(folder.database()), content);
  finish(folder, plan.cases[5]);
  collect(folder, read);
  EXPECT_EQ(content_sha256(folder.database()), content);
}

TEST_F(StudyOnDisk, DatabaseFollowsAPlanThatChanges) {
  const StudyFolder folder = finished("a");
  collect(folder, folder.read_plan());
  const std::string content = content_sha256(folder.database());
  std::string fewer = kStudy;
  fewer.replace(fewer.find(", 0.2]"), 6, "]");
  folder.write_plan(make_plan(parse_study_file(fewer, "x.toml")));
  collect(folder, folder.read_plan());
  {
    const Database database(folder.database(), Database::Mode::read);
    Statement count = database.prepare("SELECT count(*), count(DISTINCT address) FROM cases");
    ASSERT_TRUE(count.step());
    EXPECT_EQ(count.integer(0), 8);
    Statement orphans = database.prepare(
        "SELECT count(*) FROM samples WHERE number NOT IN (SELECT number FROM cases)");
    ASSERT_TRUE(orphans.step());
    EXPECT_EQ(orphans.integer(0), 0);
  }  // whoever reads keeps others from writing
  folder.write_plan(plan);
  collect(folder, folder.read_plan());
  EXPECT_EQ(content_sha256(folder.database()), content);
}

TEST_F(StudyOnDisk, SeveralProcessesMayWrite) {
  const StudyFolder alone = finished("a");
  collect(alone, alone.read_plan());
  const StudyFolder folder = planned("b");
  const FolderPlan read = folder.read_plan();
  Store(folder.database()).put_plan(read);
  std::vector<pid_t> children;
  for (int k = 0; k < 4; ++k) {
    const pid_t child = fork();
    if (child == 0) {
      for (std::size_t i = 0; i < plan.cases.size(); ++i)
        if (i % 4 == static_cast<std::size_t>(k) || i % 3 == 0)
          Store(folder.database()).put(read, made_up(plan.cases[i].address, score(plan.cases[i])));
      _exit(0);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(content_sha256(folder.database()), content_sha256(alone.database()));
}

TEST_F(StudyOnDisk, EveryTableIsExported) {
  const StudyFolder folder = finished("a");
  collect(folder, folder.read_plan());
  export_csv(folder.database(), base / "csv");
  for (const std::string& table : table_names())
    EXPECT_TRUE(fs::exists(base / "csv" / (table + ".csv"))) << table;
  const std::string cases = io::read_text_file((base / "csv" / "levels.csv").string(), 100000);
  EXPECT_NE(cases.find("1,person,1,person 1,\n"), std::string::npos) << cases;
  EXPECT_NE(cases.find("2,fit,2,0.1,0.1\n"), std::string::npos) << cases;
}

TEST_F(StudyOnDisk, AnalysisFindsTheLimitThatWasPutIn) {
  const StudyAnalysis analysis = analyse(read_study_data(finished("a")));
  ASSERT_EQ(analysis.modalities.size(), 1u);
  const ModalityAnalysis& modality = analysis.modalities[0];
  const HowLoose& answer = modality.how_loose.at("scapula");
  // The worst person scores 0.9 − 3 b.
  EXPECT_NEAR(answer.limit, (0.9 - modality.pass) / 3, 1e-9);
  EXPECT_EQ(analysis.data.units.size(), 4u);
  for (const Sensitivity& s : modality.sensitivity)
    if (s.quantity == "score" && s.input == "fit") {
      EXPECT_GT(std::abs(s.value), 0.9) << s.main_effect;
    }
  EXPECT_EQ(analysis.comfort->limit, -std::numeric_limits<double>::infinity());
  const std::string page = study_html(analysis);
  EXPECT_NE(page.find("How loose may it be?"), std::string::npos);
  EXPECT_NE(page.find("<svg"), std::string::npos);
  EXPECT_EQ(page.find("<script"), std::string::npos);
}

TEST_F(StudyOnDisk, WhereNoFitWorksTheHeadlineNamesTheNearest) {
  const StudyFolder folder = planned("a");
  for (const PlannedCase& one : plan.cases)
    write_whole(
        folder.result_file(one.address),
        record_json(made_up(one.address, one.levels[0] > 0 && one.levels[1] == 0 ? 0.95 : 0.1)));
  const StudyAnalysis analysis = analyse(read_study_data(folder));
  const std::string sentence = headlines(analysis).at(0);
  EXPECT_NE(sentence.find("no site works for 95 % of people"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("nearest is scapula: 75 % of 4 people pass at a BGM of"),
            std::string::npos)
      << sentence;
  EXPECT_EQ(study_html(analysis).find("nowhere to nowhere"), std::string::npos);
}

TEST_F(StudyOnDisk, FailedAndOpenCasesAreListedAndNotCounted) {
  const StudyFolder folder = finished("a");
  CaseRecord failed;
  failed.address = plan.cases[0].address;
  failed.reason = "no <armhole>";
  write_whole(folder.result_file(failed.address), record_json(failed));
  fs::remove(folder.result_file(plan.cases[1].address));
  const StudyAnalysis analysis = analyse(read_study_data(folder));
  EXPECT_EQ(analysis.data.done, 10);
  ASSERT_EQ(analysis.data.troubles.size(), 2u);
  EXPECT_EQ(analysis.data.troubles[0].status, "failed");
  EXPECT_EQ(analysis.data.troubles[1].status, "open");
  EXPECT_EQ(analysis.modalities[0].how_loose.at("scapula").curve[0].rated, 3);
  EXPECT_NE(study_html(analysis).find("no &lt;armhole&gt;"), std::string::npos);
}

TEST_F(StudyOnDisk, ComparisonPairsPeople) {
  const StudyFolder a = finished("a"), b = planned("b");
  for (const PlannedCase& one : plan.cases) {
    const double shift = 0.1 + 0.01 * one.levels[0];
    write_whole(b.result_file(one.address), record_json(made_up(one.address, score(one) - shift)));
  }
  const StudyComparison comparison = compare_studies(read_study_data(a), read_study_data(b));
  ASSERT_EQ(comparison.differences.size(), 3u);
  // Of the second fit, where no score leaves 0 ... 1, to which they are clamped.
  const PairedDifference& second = comparison.differences[1];
  EXPECT_EQ(second.pairs, 4);
  EXPECT_NEAR(second.mean, -0.115, 1e-12);
  // People differ by 0.05, so the interval would be four times as wide if they were not paired.
  EXPECT_LT(second.interval.high - second.interval.low, 0.025);
  EXPECT_TRUE(second.differs());
  EXPECT_EQ(second.better, 0);
}

TEST_F(StudyOnDisk, GalleryIsThereWhereOutputsWereKept) {
  const StudyFolder folder = finished("a");
  Progress silent;
  const Gallery none = make_gallery(folder, folder.read_plan(), silent);
  EXPECT_EQ(none.cases, 0);
  EXPECT_TRUE(none.png.empty() && none.why.empty());
  const StudyAnalysis analysis = analyse(read_study_data(folder));
  EXPECT_EQ(study_html(analysis, none).find("<img"), std::string::npos);
  EXPECT_NE(study_html(analysis, {"png", "", 2}).find("drapes of 2 cases"), std::string::npos);
  EXPECT_NE(study_html(analysis, {"", "no <screen>", 2}).find("no &lt;screen&gt;"),
            std::string::npos);
}

TEST(WorkerProcess, TellsHowAProgramEnded) {
  const ProcessEnd good = run_to_end({"/bin/sh", "-c", "echo said; exit 3"});
  EXPECT_EQ(good.exit_code, 3);
  EXPECT_EQ(good.signal, 0);
  EXPECT_EQ(good.output, "said");
  EXPECT_EQ(run_to_end({"/bin/sh", "-c", "kill -9 $$"}).signal, 9);
  EXPECT_EQ(run_to_end({"/no/such/program"}).exit_code, 127);
}

}  // namespace
}  // namespace loosefit::study
