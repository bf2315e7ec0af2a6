#include <gtest/gtest.h>

#include <filesystem>

#include "loosefit/io/text_file.h"
#include "support/program_output.h"
#include "support/scratch_folder.h"

// The commands of a study that run no case: documents of theirs, and folders that are none.
namespace loosefit {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::json;

struct StudyCommand : ::testing::Test {
  const support::ScratchFolder base;
  std::string path(const std::string& name) const { return (base / name).string(); }
  std::string file(const std::string& name, const std::string& text) const {
    fs::create_directories((base / name).parent_path());
    io::write_text_file(path(name), text);
    return path(name);
  }
  Json document(const std::string& arguments, int code = 0) {
    const ProgramOutput run = run_apart(base, arguments);
    EXPECT_EQ(run.exit_code, code) << arguments << "\n" << run.err;
    const Json json = run.document();
    EXPECT_TRUE(json.is_object()) << arguments << "\n" << run.out;
    return json.is_object() ? json : Json::object();
  }
  int files_in(const std::string& folder) const {
    return static_cast<int>(
        std::distance(fs::directory_iterator(base / folder), fs::directory_iterator()));
  }
  std::string planned(const std::string& name) {
    const std::string study =
        file(name + ".toml",
             "[study]\nmodalities = [\"pressure\"]\n[[axis]]\nname = \"fit\"\n"
             "key = \"garment.fit.chest\"\nvalues = [0.05, 0.2]\n");
    EXPECT_EQ(document("study plan " + study + " --json -o " + path(name))["open"], 2);
    return path(name);
  }
};

TEST_F(StudyCommand, EveryOneOfThemMakesADocument) {
  const std::string folder = planned("a"), other = planned("b");
  EXPECT_EQ(document("study status " + folder + " --json")["open"], 2);
  const Json report = document("study report " + folder + " --json");
  EXPECT_EQ(report["cases"], 2);
  EXPECT_EQ(report["done"], 0);
  const Json exported = document("study export " + folder + " --json");
  EXPECT_EQ(exported["folder"], folder + "/csv");
  EXPECT_EQ(exported["content_sha256"].get<std::string>().size(), 64u);
  EXPECT_GT(exported["files"].size(), 10u);
  for (const Json& name : exported["files"])
    EXPECT_TRUE(fs::exists(fs::path(folder) / "csv" / name)) << name;
  EXPECT_EQ(document("study compare " + folder + " " + other + " --json", 2)["exit_code"], 2)
      << "nothing has run";
}

TEST_F(StudyCommand, WhatIsNoStudyStaysAsItIs) {
  for (const char* command : {"status", "report", "export"}) {
    document(std::string("study ") + command + " " + path("nowhere") + " --json", 2);
    EXPECT_FALSE(fs::exists(path("nowhere"))) << command;
  }
  file("mine/notes.txt", "keep");
  const std::string study = file("study.toml", "[study]\nmodalities = [\"pressure\"]\n");
  for (const char* command : {"plan", "run"})
    document(std::string("study ") + command + " " + study + " --json -o " + path("mine"), 2);
  for (const char* command : {"status", "report", "export"})
    document(std::string("study ") + command + " " + path("mine") + " --json", 2);
  EXPECT_EQ(files_in("mine"), 1);
}

// A terminal that is gone, or a full disk, takes no warning.
TEST_F(StudyCommand, WhatNobodyCanReadEndsNoWork) {
  const std::string study =
      file("warns.toml",
           "[study]\nmodalities = [\"pressure\"]\n[scenario.donning]\nrepeats = 1\n[[axis]]\n"
           "name = \"idle\"\nkey = \"donning.shift\"\nvalues = [0.01, 0.02]\n");
  const std::string command = std::string(LOOSEFIT_BINARY) + " study plan " + study;
  ASSERT_NE(run_program(command).output.find("warning: axis idle"), std::string::npos);
  const ProgramRun run = run_program(command + " 2>/dev/full");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_NE(run.output.find("cases    2"), std::string::npos) << run.output;
}

TEST_F(StudyCommand, AComparisonReplacesNoFile) {
  const std::string folder = planned("a"), mine = file("mine.csv", "1,2,3");
  const Json refused = document("study compare " + folder + " " + folder + " --json -o " + mine, 2);
  EXPECT_EQ(refused["error"]["found"], "a file that is there already");
  EXPECT_EQ(io::read_text_file(mine, 1000), "1,2,3");
  const std::string limits = file("other.limits.csv", "4,5,6");
  const Json again =
      document("study compare " + folder + " " + folder + " --json -o " + path("other.csv"), 2);
  EXPECT_EQ(again["error"]["found"], "a file that is there already");
  EXPECT_EQ(io::read_text_file(limits, 1000), "4,5,6");
  EXPECT_FALSE(fs::exists(path("other.csv")));
}

}  // namespace
}  // namespace loosefit
