#include "loosefit/study/study_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "loosefit/base/error.h"
#include "loosefit/io/text_file.h"
#include "support/study_on_disk.h"

// The folder of a study: whole files alone count, and what is not ours stays as it is.
namespace loosefit::study {
namespace {

using Paths = std::vector<fs::path>;

/// Names that things have now that writing a plan has set aside.
Paths set_aside_by(const StudyFolder& folder, const Plan& plan) {
  Paths aside;
  folder.write_plan(plan, [&](const fs::path& file) { aside.push_back(file); });
  return aside;
}

// As a runner leaves it that is killed while it writes, after each of its files in turn.
TEST_F(StudyOnDisk, APlanThatWasCutOffIsWrittenToItsEndAndNothingHalfWrittenStays) {
  const StudyFolder whole = planned("whole");
  const std::string first = plan.cases.front().address, last = plan.cases.back().address;
  const std::vector<fs::path> order = {whole.path() / "plan.json", whole.path() / "study.toml",
                                       whole.scenario_file(first), whole.scenario_file(last)};
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
    EXPECT_EQ(files, static_cast<int>(plan.cases.size()) + 2);
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

// A link to itself, as a folder to which one has no access: what is behind it is not known.
TEST_F(StudyOnDisk, AResultThatCannotBeLookedAtIsNotMissing) {
  const StudyFolder folder = finished("a");
  const FolderPlan read = folder.read_plan();
  const fs::path result = folder.result_file(plan.cases[2].address);
  fs::remove(result);
  fs::create_symlink(result.filename(), result);
  EXPECT_THROW(folder.record(plan.cases[2].address), IoError);
  EXPECT_THROW(folder.state(read), IoError);
  const fs::path file = folder.path() / "plan.json";
  fs::remove(file);
  fs::create_symlink(file.filename(), file);
  EXPECT_THROW(folder.read_plan(), IoError);
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

// Somebody else's plan.json makes no study of a folder, and the lock is asked for before anything
// is written.
TEST_F(StudyOnDisk, AForeignPlanIsNotReplacedAndAForeignFolderGetsNoLock) {
  const StudyFolder mine(base / "mine");
  fs::create_directories(mine.path());
  for (const char* text : {"{\"tasks\": [1, 2]}", "[]", "not JSON at all"}) {
    const fs::path file = mine.path() / "plan.json";
    io::write_text_file(file.string(), text);
    EXPECT_THROW(mine.write_plan(plan), InvalidInput) << text;
    EXPECT_THROW(StudyLock{mine}, InvalidInput) << text;
    EXPECT_EQ(io::read_text_file(file.string(), 1000), text);
    EXPECT_EQ(std::distance(fs::directory_iterator(mine.path()), fs::directory_iterator()), 1);
  }
}

TEST_F(StudyOnDisk, AnotherStudyDoesNotTakeTheFolder) {
  const StudyFolder folder = planned("a");
  const auto renamed = [&](const std::string& from, const std::string& to) {
    std::string text = kStudy;
    text.replace(text.find("\"x\""), 3, "\"y\"");
    if (!from.empty()) text.replace(text.find(from), from.size(), to);
    return make_plan(parse_study_file(text, "y.toml"));
  };
  const std::string before = io::read_text_file((folder.path() / "study.toml").string(), 10000);
  EXPECT_THROW(folder.write_plan(renamed("0.0, 0.1, 0.2", "0.5, 0.6")), InvalidInput);
  EXPECT_EQ(io::read_text_file((folder.path() / "study.toml").string(), 10000), before);
  EXPECT_EQ(folder.read_plan().name, "x");
  folder.write_plan(renamed("0.2]", "0.3]"));
  EXPECT_EQ(folder.read_plan().name, "y") << "another name for what is mostly the same";
}

TEST_F(StudyOnDisk, AStudyFileThatSomebodyChangedIsSetAside) {
  const StudyFolder folder = planned("a");
  const fs::path file = folder.path() / "study.toml";
  const std::string mine = std::string(kStudy) + "# my note\n";
  io::write_text_file(file.string(), mine);
  EXPECT_EQ(set_aside_by(folder, plan), Paths{file.string() + ".changed-1"});
  EXPECT_EQ(io::read_text_file(file.string() + ".changed-1", 10000), mine);
  EXPECT_EQ(io::read_text_file(file.string(), 10000), kStudy);
  EXPECT_TRUE(set_aside_by(folder, plan).empty());
  // What is asked for is no change, though the plan does not know it yet.
  io::write_text_file(file.string(), mine);
  EXPECT_TRUE(set_aside_by(folder, make_plan(parse_study_file(mine, "mine.toml"))).empty());
}

TEST_F(StudyOnDisk, AnotherStudyFileDoesNotTakeTheFolderOfADamagedPlan) {
  const StudyFolder folder = planned("a");
  const fs::path file = folder.path() / "plan.json";
  const Plan other = make_plan(parse_study_file(std::string(kStudy) + "# another\n", "other.toml"));
  for (const std::string& damage : {std::string("mine"), std::string()}) {
    io::write_text_file(file.string(), damage);
    EXPECT_THROW(folder.write_plan(other), InvalidInput);
    EXPECT_EQ(io::read_text_file(file.string(), 100), damage);
  }
  fs::remove(file);
  EXPECT_THROW(folder.write_plan(other), InvalidInput);
  EXPECT_EQ(io::read_text_file((folder.path() / "study.toml").string(), 10000), kStudy);
  io::write_text_file(file.string(), "mine");
  EXPECT_EQ(set_aside_by(folder, plan), Paths{file.string() + ".damaged-1"});
  EXPECT_EQ(io::read_text_file(file.string() + ".damaged-1", 100), "mine");
}

TEST_F(StudyOnDisk, APlanThatIsDamagedOrGoneIsWrittenAnew) {
  const StudyFolder folder = planned("a");
  const fs::path file = folder.path() / "plan.json";
  const std::string good = io::read_text_file(file.string(), 1000000);
  io::write_text_file(file.string(), good.substr(0, good.size() / 2));
  EXPECT_THROW(folder.read_plan(), InvalidInput);
  folder.write_plan(plan);
  EXPECT_EQ(io::read_text_file(file.string(), 1000000), good);
  fs::remove(file);
  folder.write_plan(plan);
  EXPECT_EQ(io::read_text_file(file.string(), 1000000), good);
}

TEST_F(StudyOnDisk, ALockFileOfSomebodyElseKeepsItsText) {
  const StudyFolder folder = planned("a");
  const std::string file = (folder.path() / ".lock").string();
  io::write_text_file(file, "mine");
  {
    const StudyLock first(folder);
    EXPECT_THROW(StudyLock{folder}, InvalidInput) << "it locks all the same";
  }
  EXPECT_EQ(io::read_text_file(file, 1000), "mine");
}

TEST_F(StudyOnDisk, APlanThatTheProgramDidNotWriteIsRefusedWithTheKey) {
  const StudyFolder folder = planned("a");
  const std::string file = (folder.path() / "plan.json").string();
  const std::string good = io::read_text_file(file, 1000000);
  const auto complaint = [&](const std::string& from, const std::string& to) -> std::string {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    io::write_text_file(file, text);
    try {
      folder.read_plan();
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "accepted";
  };
  const std::string address = plan.cases[0].address;
  EXPECT_NE(complaint(address, "../../../etc").find("plan.json: cases.address: found"),
            std::string::npos);
  EXPECT_NE(complaint("\"number\": 2", "\"number\": 100000000").find("cases.number: found"),
            std::string::npos);
  const std::string levels = "\"levels\": [\n    0,\n    0\n   ]";
  ASSERT_NE(good.find(levels), std::string::npos);
  for (const char* wrong : {"[0, 99]", "[0, -1]", "[0]"})
    EXPECT_NE(complaint(levels, std::string("\"levels\": ") + wrong).find("cases.levels: found"),
              std::string::npos)
        << wrong;
  EXPECT_EQ(complaint(levels, "\"levels\": [3, 2]"), "accepted");
}

// A case is what its address says.
TEST_F(StudyOnDisk, AScenarioThatSomebodyChangedIsWrittenAnew) {
  const StudyFolder folder = planned("a");
  const std::string file = folder.scenario_file(plan.cases[1].address).string();
  const std::string mine = "[garment]\npattern = \"trousers\"\n";
  io::write_text_file(file, mine);
  EXPECT_EQ(set_aside_by(folder, plan), Paths{file + ".changed-1"});
  EXPECT_EQ(io::read_text_file(file, 1000000), plan.cases[1].toml);
  EXPECT_EQ(io::read_text_file(file + ".changed-1", 1000000), mine);
  // What changes no result is the same case.
  io::write_text_file(file, plan.cases[1].toml + "# seen\n");
  EXPECT_TRUE(set_aside_by(folder, plan).empty());
  EXPECT_EQ(io::read_text_file(file, 1000000), plan.cases[1].toml);
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

}  // namespace
}  // namespace loosefit::study
