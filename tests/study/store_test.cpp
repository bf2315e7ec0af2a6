#include "loosefit/study/store.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "loosefit/base/build_id.h"
#include "loosefit/base/error.h"
#include "loosefit/io/text_file.h"
#include "loosefit/study/analysis.h"
#include "loosefit/study/analysis_json.h"
#include "loosefit/study/compare.h"
#include "loosefit/study/gallery.h"
#include "loosefit/study/run_here.h"
#include "loosefit/study/study_page.h"
#include "loosefit/study/worker_process.h"
#include "support/study_on_disk.h"

// Records and database, with results that are made up.
namespace loosefit::study {
namespace {

TEST(CaseRecord, ReadsBackAsTheSameBits) {
  const CaseRecord record = made_up(std::string(64, 'a'), 0.1 + 0.2);
  const CaseRecord again = parse_record(record_json(record), "x");
  EXPECT_EQ(record_json(again), record_json(record));
  EXPECT_EQ(again.samples[0].margin, 0.1 + 0.2);
  EXPECT_EQ(again.residual, 0.1 / 3);
  EXPECT_TRUE(std::isnan(again.body.at("odd")));
}

TEST(CaseRecord, KnowsWhetherAnotherBuildMadeIt) {
  CaseRecord record = made_up("a", 0.5);
  EXPECT_TRUE(of_another_build(record)) << "of a program that did not tell its build";
  record.versions["build"] = build_id();
  EXPECT_FALSE(of_another_build(parse_record(record_json(record), "result.json")));
  record.versions["build"] = std::string(40, '0');
  EXPECT_TRUE(of_another_build(record));
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
  const std::string foreign = "this is no database, but long enough for one";
  for (const char* number : {"1", "2"}) {
    io::write_text_file(folder.database().string(), foreign);
    collect(folder, read);
    EXPECT_EQ(content_sha256(folder.database()), content);
    EXPECT_EQ(io::read_text_file(folder.database().string() + ".damaged-" + number, 1000), foreign)
        << "it may be somebody's";
  }
  {  // tables of one's own beside ours
    const Database database(folder.database(), Database::Mode::write);
    database.run("CREATE TABLE remarks (text TEXT); INSERT INTO remarks VALUES ('keep')");
  }
  fs::remove(folder.result_file(plan.cases[5].address));
  collect(folder, read);
  EXPECT_NE(content_sha256(folder.database()), content);
  {
    const Database database(folder.database(), Database::Mode::read);
    Statement kept = database.prepare("SELECT text FROM remarks");
    ASSERT_TRUE(kept.step());
    EXPECT_EQ(kept.text(0), "keep");
    Statement open = database.prepare(
        "SELECT number FROM cases WHERE status = 'open' AND reason IS NULL AND residual IS NULL");
    ASSERT_TRUE(open.step());
    EXPECT_EQ(open.integer(0), plan.cases[5].number);
    EXPECT_FALSE(open.step());
  }
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
  std::set<std::string> in_it;
  const Database database(folder.database(), Database::Mode::read);
  for (Statement rows = database.prepare("SELECT name FROM sqlite_master WHERE type = 'table'");
       rows.step();)
    in_it.insert(rows.text(0));
  EXPECT_GT(in_it.size(), 10u);
  EXPECT_EQ(std::set<std::string>(table_names().begin(), table_names().end()), in_it);
  for (const std::string& table : in_it)
    EXPECT_TRUE(fs::exists(base / "csv" / (table + ".csv"))) << table;
  const std::string cases = io::read_text_file((base / "csv" / "levels.csv").string(), 100000);
  EXPECT_NE(cases.find("1,person,1,person 1,\n"), std::string::npos) << cases;
  EXPECT_NE(cases.find("2,fit,2,0.1,0.1\n"), std::string::npos) << cases;
}

TEST_F(StudyOnDisk, AnExportReplacesOnlyAnEarlierOne) {
  const StudyFolder folder = finished("a");
  collect(folder, folder.read_plan());
  const std::string mine = (base / "csv" / "sites.csv").string();
  fs::create_directories(base / "csv");
  io::write_text_file(mine, "my own sites\n");
  EXPECT_THROW(export_csv(folder.database(), base / "csv"), InvalidInput);
  EXPECT_EQ(io::read_text_file(mine, 1000), "my own sites\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(base / "csv"), fs::directory_iterator()), 1);
  fs::remove(mine);
  io::write_text_file((base / "csv" / "notes.txt").string(), "keep");
  for (int time = 0; time < 2; ++time)
    EXPECT_EQ(export_csv(folder.database(), base / "csv"), [] {
      std::vector<std::string> names;
      for (const std::string& table : table_names()) names.push_back(table + ".csv");
      return names;
    }());
  EXPECT_EQ(io::read_text_file((base / "csv" / "notes.txt").string(), 1000), "keep");
}

TEST_F(StudyOnDisk, AnalysisFindsTheLimitThatWasPutIn) {
  const StudyAnalysis analysis = analyse(read_study_data(finished("a")));
  ASSERT_EQ(analysis.modalities.size(), 1u);
  const ModalityAnalysis& modality = analysis.modalities[0];
  const HowLoose& answer = modality.how_loose.at("scapula");
  // The worst person scores 0.9 − 3 b.
  EXPECT_NEAR(answer.limit, (0.9 - modality.pass) / 3, 1e-9);
  EXPECT_EQ(analysis.data.units.size(), 4u);
  int of_the_fit = 0;
  for (const Sensitivity& s : modality.sensitivity)
    if (s.quantity == "score" && s.input == "fit") {
      ++of_the_fit;
      EXPECT_GT(std::abs(s.value), 0.9) << s.main_effect;
    }
  EXPECT_EQ(of_the_fit, 2);  // rank correlation and share of variance
  EXPECT_EQ(headlines(analysis).back(),
            "comfort: for 95 % of people comfortable at all fits tried");
  EXPECT_EQ(analysis.comfort->limit, -std::numeric_limits<double>::infinity());
  const std::string page = study_html(analysis);
  EXPECT_NE(page.find("How loose may it be?"), std::string::npos);
  EXPECT_NE(page.find("<svg"), std::string::npos);
  EXPECT_NE(page.find("scapula, 90 % interval"), std::string::npos);
  EXPECT_NE(page.find("class=\"box good\""), std::string::npos);
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
  const std::string page = study_html(analysis);
  EXPECT_EQ(page.find("nowhere to nowhere"), std::string::npos);
  EXPECT_EQ(page.find("class=\"box good\""), std::string::npos);
  EXPECT_NE(page.find("75 % at 0.00"), std::string::npos);
}

// Who could not be rated may be the worst: what so many people carry is said of those who were.
TEST_F(StudyOnDisk, PeopleWithoutAnyScoreCarryNoStatementAboutThePopulation) {
  const StudyFolder folder = planned("a");
  for (const PlannedCase& one : plan.cases)
    if (one.levels[0] > 0) finish(folder, one);
  const StudyAnalysis analysis = analyse(read_study_data(folder));
  EXPECT_EQ(rated_units(analysis.data), 3);
  const std::string page = study_html(analysis);
  EXPECT_NE(page.find("With 3 independent people"), std::string::npos);
  EXPECT_NE(page.find("1 of the 4 has no score at all"), std::string::npos);
  const nlohmann::json json = nlohmann::json::parse(analysis_json(analysis));
  EXPECT_EQ(json["rated"], 3);
  EXPECT_NEAR(json["worst_is_below_p5_with_confidence"], 1 - std::pow(0.95, 3), 1e-12);
}

// Chosen ease is in metres; what a wearer may have of it is a BGM of that wearer.
TEST_F(StudyOnDisk, ChosenEaseIsAnsweredAsABodyGarmentMobility) {
  const Plan eased = make_plan(parse_study_file(
      "[study]\nname = \"x\"\nmodalities = [\"imu-uncalibrated\"]\n"
      "[[axis]]\nname = \"person\"\npeople = { statistics = \"ansur-2012\", count = 4 }\n"
      "[[axis]]\nname = \"ease\"\nease = { chosen = \"blouse\", count = 5 }\n",
      "x.toml"));
  const StudyFolder folder(base / "eased");
  fs::create_directories(base);
  folder.write_plan(eased);
  const StudyData data = read_study_data(folder);
  std::vector<double> bgm;
  for (const PlannedCase& one : eased.cases) bgm.push_back(*one.looseness);
  std::sort(bgm.begin(), bgm.end());
  ASSERT_EQ(bgm.size(), 20u);
  ASSERT_EQ(data.level_bgm.size(), 5u);
  for (std::size_t bin = 0; bin < 5; ++bin)
    EXPECT_NEAR(data.level_bgm[bin], std::accumulate(&bgm[4 * bin], &bgm[4 * bin] + 4, 0.0) / 4,
                1e-12);
  // As a plan of an earlier program has it: in metres, without what each wearer makes of them.
  const fs::path file = folder.path() / "plan.json";
  nlohmann::json earlier = nlohmann::json::parse(io::read_text_file(file.string(), 1000000));
  for (nlohmann::json& one : earlier["cases"]) one.erase("looseness");
  write_whole(file, earlier.dump());
  EXPECT_NO_THROW(folder.read_plan());
  EXPECT_THROW(read_study_data(folder), InvalidInput);
}

// A fit that nobody has worn yet is neither comfortable nor uncomfortable.
TEST_F(StudyOnDisk, ComfortOfFitsThatWereNotTriedYetIsNotKnown) {
  const StudyFolder folder = planned("a");
  const auto comfort = [&] { return headlines(analyse(read_study_data(folder))).back(); };
  for (const PlannedCase& one : plan.cases)
    if (one.levels[1] < 2) finish(folder, one);
  EXPECT_EQ(comfort(),
            "comfort: for 95 % of people comfortable at all fits tried; not known at 0.20");
  for (const PlannedCase& one : plan.cases) finish(folder, one);
  EXPECT_EQ(comfort(), "comfort: for 95 % of people comfortable at all fits tried");
}

// Who was listed or spread evenly is no sample: nothing is said of a population.
TEST_F(StudyOnDisk, PeopleWhoWereNotDrawnCarryNoStatementAboutThePopulation) {
  fs::create_directories(base);
  io::write_text_file((base / "people.csv").string(),
                      "name,sex,height,chest\nA,female,1.65,0.9\nB,male,1.8,1.0\n");
  for (const std::string people : {"{ file = \"people.csv\" }",
                                   "{ statistics = \"ansur-2012\", count = 4, stratified = true }",
                                   "{ statistics = \"ansur-2012\", count = 4 }"}) {
    SCOPED_TRACE(people);
    const Plan asked =
        make_plan(parse_study_file("[study]\nname = \"x\"\nmodalities = [\"imu-uncalibrated\"]\n"
                                   "[[axis]]\nname = \"person\"\npeople = " +
                                       people + "\n",
                                   (base / "x.toml").string()));
    const StudyFolder folder(base / "a");
    fs::remove_all(folder.path());
    folder.write_plan(asked);
    for (const PlannedCase& one : asked.cases)
      write_whole(folder.result_file(one.address), record_json(made_up(one.address, 0.9)));
    const StudyAnalysis analysis = analyse(read_study_data(folder));
    const bool drawn = people.find("count = 4 }") != std::string::npos;
    EXPECT_EQ(is_sample(analysis.data), drawn);
    EXPECT_EQ(study_html(analysis).find("independent people") != std::string::npos, drawn);
    EXPECT_EQ(nlohmann::json::parse(analysis_json(analysis))["worst_is_below_p5_with_confidence"]
                  .is_null(),
              !drawn);
  }
}

// A fit at which nobody could be rated is no nearest one, whatever comes after it.
TEST_F(StudyOnDisk, TheNearestFitIsOneAtWhichSomebodyIsRated) {
  const StudyFolder folder = planned("a");
  for (const PlannedCase& one : plan.cases)
    if (one.levels[1] > 0)
      write_whole(folder.result_file(one.address),
                  record_json(made_up(one.address, one.levels[0] > 0 ? 0.95 : 0.1)));
  const StudyAnalysis analysis = analyse(read_study_data(folder));
  const std::string sentence = headlines(analysis).at(0);
  EXPECT_NE(sentence.find("75 % of 4 people pass"), std::string::npos) << sentence;
  EXPECT_EQ(sentence.find("nan"), std::string::npos) << sentence;
  const std::string json = analysis_json(analysis);
  EXPECT_EQ(json.find("\"uncomfortable_share_p95\": [\n   \"beyond"), std::string::npos) << json;
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
  EXPECT_LT(second.interval.high, 0);
  EXPECT_FALSE(second.differs()) << "four people";
  EXPECT_EQ(second.better, 0);
  const std::string json = comparison_json(comparison);
  EXPECT_NE(json.find("\"differs\": false"), std::string::npos) << json;
  EXPECT_NE(json.find("\"people\": 4"), std::string::npos) << json;
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

/// A program that does to its worker what is asked of it.
std::string program(const fs::path& folder, const std::string& deed) {
  fs::create_directories(folder);
  const fs::path file = folder / "program.sh";
  io::write_text_file(file.string(), "#!/bin/sh\n" + deed + "\n");
  fs::permissions(file, fs::perms::owner_all);
  return file.string();
}

TEST_F(StudyOnDisk, ACaseThatCrashesTheProgramIsRecordedAndStopsNothing) {
  const StudyFolder folder = planned("a");
  const std::string log = (base / "log").string();
  RunnerOptions options;
  options.program = program(base / "bin", "echo $4 >> " + log + "; kill -SEGV $$");
  options.jobs = 2;
  const std::vector<std::string> two = {plan.cases[0].address, plan.cases[1].address};
  int seen = 0;
  Progress silent;
  const auto given_up = run_here(
      folder, two, options, [&](const CaseRecord&) { ++seen; }, silent);
  EXPECT_TRUE(given_up.empty());
  EXPECT_EQ(seen, 2);
  for (const std::string& address : two) {
    const std::optional<CaseRecord> record = folder.record(address);
    ASSERT_TRUE(record);
    EXPECT_EQ(record->status, CaseStatus::failed);
    EXPECT_NE(record->reason.find("crashed 3 times"), std::string::npos) << record->reason;
  }
  const std::string tried = io::read_text_file(log, 10000);
  EXPECT_EQ(std::count(tried.begin(), tried.end(), '\n'), 6);
}

TEST_F(StudyOnDisk, TroubleOfTheMachineStopsTheStudyAndIsTold) {
  const StudyFolder folder = planned("a");
  RunnerOptions options;
  options.program = program(base / "bin", "echo 'error: disk full' >&2; exit 2");
  options.jobs = 1;
  Progress silent;
  try {
    run_here(
        folder, {plan.cases[0].address}, options, [](const CaseRecord&) {}, silent);
    FAIL();
  } catch (const IoError& error) {
    EXPECT_STREQ(error.what(), "disk full");
  }
  EXPECT_FALSE(folder.record(plan.cases[0].address));
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
