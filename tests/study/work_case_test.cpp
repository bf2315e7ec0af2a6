#include "loosefit/study/work_case.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/io/run_folder.h"
#include "loosefit/io/text_file.h"
#include "support/study_on_disk.h"

// What is recorded of a case is of the inputs that gave it its address, and of the case alone.
namespace loosefit::study {
namespace {

/// Changes a file as soon as the case begins.
class ChangesAFile : public Progress {
 public:
  explicit ChangesAFile(fs::path file) : file_(std::move(file)) {}
  void stage(const std::string&) override {
    io::write_text_file(file_.string(), "no pieces either");
  }
  void update(double, const std::string&) override {}

 private:
  fs::path file_;
};

/// Makes another whole output as soon as the case begins.
class RunsMeanwhile : public Progress {
 public:
  explicit RunsMeanwhile(fs::path output) : output_(std::move(output)) {}
  void stage(const std::string&) override {
    if (fs::exists(output_)) return;
    io::RunFolder other = io::RunFolder::create(output_);
    io::write_text_file((other.path() / "drape.vtp").string(), "of another process");
    other.commit();
  }
  void update(double, const std::string&) override {}

 private:
  fs::path output_;
};

struct WorkCase : StudyOnDisk {
  fs::path pattern = base / "top.dxf", card = base / "mine.toml";

  /// A study of one case, of a pattern file that is none.
  StudyFolder of_files() {
    fs::create_directories(base);
    io::write_text_file(pattern.string(), "no pieces");
    const std::string shipped = LOOSEFIT_SOURCE_DIR "/data/scorecards/pressure.toml";
    io::write_text_file(card.string(), io::read_text_file(shipped, 100000));
    plan = make_plan(parse_study_file(
        "[study]\nmodalities = [\"mine.toml\"]\n[scenario.garment]\npattern = \"top.dxf\"\n",
        (base / "x.toml").string()));
    return planned("a");
  }
  /// \param expected part of the complaint
  void expect_no_record(const StudyFolder& folder, const WorkOptions& options, Progress& progress,
                        const std::string& expected) const {
    const std::string address = plan.cases.front().address;
    try {
      work_case(folder, folder.read_plan(), address, options, progress);
      FAIL() << "recorded: " << folder.record(address)->reason;
    } catch (const IoError& error) {
      EXPECT_NE(std::string(error.what()).find(expected), std::string::npos) << error.what();
    }
    EXPECT_FALSE(fs::exists(folder.result_file(address)));
  }
};

TEST_F(WorkCase, OfWhichAnInputHasChangedSinceThePlanIsNotRecorded) {
  for (const bool changes_card : {false, true}) {
    const StudyFolder folder = of_files();
    const fs::path file = changes_card ? card : pattern;
    const std::string before = io::read_text_file(file.string(), 100000);
    io::write_text_file(file.string(), before + "\n# changed\n");
    Progress silent;
    expect_no_record(folder, {}, silent, "has changed since the plan was made");
  }
}

TEST_F(WorkCase, OfWhichAnInputChangesMeanwhileIsNotRecorded) {
  const StudyFolder folder = of_files();
  ChangesAFile progress(pattern);
  expect_no_record(folder, {}, progress, "has changed since the plan was made");
}

TEST_F(WorkCase, ThatFailsByItselfIsRecorded) {
  const StudyFolder folder = of_files();
  Progress silent;
  const std::string address = plan.cases.front().address;
  work_case(folder, folder.read_plan(), address, {}, silent);
  ASSERT_TRUE(folder.record(address));
  EXPECT_EQ(folder.record(address)->status, CaseStatus::failed);
}

TEST_F(WorkCase, WhoseOutputWouldReplaceAFileOfSomebodyIsNotRecordedAsFailed) {
  const StudyFolder folder = of_files();
  const fs::path mine = folder.case_folder(plan.cases.front().address) / "output" / "drape.vtp";
  fs::create_directories(mine.parent_path());
  io::write_text_file(mine.string(), "mine");
  Progress silent;
  WorkOptions keeping;
  keeping.keep_output = true;
  expect_no_record(folder, keeping, silent, "output");
  EXPECT_EQ(io::read_text_file(mine.string(), 100), "mine");
}

TEST_F(WorkCase, WhoseOutputAnotherProcessHasMadeMeanwhileIsNotRecordedAsFailed) {
  plan = make_plan(parse_study_file(
      "[study]\nmodalities = [\"ecg\"]\n[scenario.garment]\npattern = \"t-shirt\"\n"
      "[scenario.donning]\nmovements = []\n"
      "[scenario.simulation]\nedge_length = 0.05\nmax_iterations = 1\n",
      (base / "x.toml").string()));
  const StudyFolder folder = planned("a");
  const fs::path output = folder.case_folder(plan.cases.front().address) / "output";
  RunsMeanwhile progress(output);
  WorkOptions keeping;
  keeping.keep_output = true;
  expect_no_record(folder, keeping, progress, "made meanwhile");
  EXPECT_EQ(io::read_text_file((output / "drape.vtp").string(), 100), "of another process");
}

}  // namespace
}  // namespace loosefit::study
