#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "loosefit/io/text_file.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"

// What people keep in an output folder survives every command, on a full disk too, and a command
// whose output does not arrive does not succeed.
namespace loosefit {
namespace fs = std::filesystem;
namespace {

// A drape that is stopped long before it settles: quick, and ends with exit code 1.
const char* const kStopped = "[simulation]\nedge_length = 0.05\nmax_iterations = 2\nthreads = 1\n";
const std::string kLoosefit = LOOSEFIT_BINARY;

struct OutputSafety : ::testing::Test {
  const support::ScratchFolder base;
  std::string out = (base / "out").string();

  std::string file(const std::string& name, const std::string& text) const {
    fs::create_directories((base / name).parent_path());
    io::write_text_file((base / name).string(), text);
    return (base / name).string();
  }
  std::string text(const std::string& name) const {
    return io::read_text_file((base / name).string(), 100000000);
  }
  std::map<std::string, std::string> everything() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(base))
      files[entry.path().string()] =
          entry.is_regular_file() ? io::read_text_file(entry.path().string(), 100000000) : "";
    return files;
  }
  static ProgramRun loosefit(const std::string& arguments) {
    return run_program(kLoosefit + " " + arguments);
  }
  /// With no file larger than so many times 1024 bytes: writing fails half-way, as on a full disk.
  static ProgramRun on_full_disk(int size, const std::string& arguments) {
    return run_program("bash -c \"trap '' XFSZ; ulimit -f " + std::to_string(size) + "; " +
                       kLoosefit + " " + arguments + "\"");
  }
  ProgramRun run(const std::string& scenario) const {
    return loosefit("run " + scenario + " --no-pictures -q -o " + out);
  }
};

void expect_refused(const ProgramRun& run, const std::string& phrase) {
  EXPECT_EQ(run.exit_code, 2) << run.output;
  EXPECT_NE(run.output.find("error: "), std::string::npos) << run.output;
  EXPECT_NE(run.output.find(phrase), std::string::npos) << run.output;
}

TEST_F(OutputSafety, AForeignSummaryMakesNoOutput) {
  const std::string scenario = file("case.toml", kStopped);
  file("out/summary.json", "{\"title\": \"My thesis\", \"versions\": {}}");
  file("out/validation.json", "{}");
  file("out/data/measured.csv", "1,2,3");
  const auto before = everything();
  expect_refused(run(scenario), "not an earlier output");
  expect_refused(loosefit("validate --quick --only T1 -o " + out), "not an earlier output");
  expect_refused(loosefit("body --height 1.7 -o " + out), "summary.json");
  EXPECT_EQ(everything(), before);
}

TEST_F(OutputSafety, ForeignFilesSurviveTheNextRunAndEditedOnesStopIt) {
  file("case.toml", kStopped);
  ASSERT_EQ(run((base / "case.toml").string()).exit_code, 1);
  const std::string scenario = file("out/case.toml", kStopped);
  file("out/notes.txt", "mine");
  file("out/maps/mine.png", "mine");
  file("out/ranking-mine.csv", "mine");
  const std::string first = text("out/summary.json");
  ASSERT_EQ(run(scenario).exit_code, 1);
  EXPECT_NE(text("out/summary.json"), first);
  EXPECT_EQ(text("out/case.toml"), kStopped);
  for (const char* name : {"out/notes.txt", "out/maps/mine.png", "out/ranking-mine.csv"})
    EXPECT_EQ(text(name), "mine");

  // The resolved scenario, edited, as the scenario of the next run into the same folder.
  const std::string resolved = file("out/scenario.toml", text("out/scenario.toml") + "# mine\n");
  const auto before = everything();
  expect_refused(run(resolved), "out: scenario.toml: found");
  EXPECT_EQ(everything(), before);
  EXPECT_EQ(loosefit("map -q --allow-unsettled " + out).exit_code, 1) << "an edit for the maps";
  EXPECT_EQ(text("out/scenario.toml"), before.at(resolved));
  file("out/report.html", "edited");
  EXPECT_EQ(loosefit("map -q --allow-unsettled " + out).exit_code, 1) << "writes no report";
  EXPECT_EQ(text("out/report.html"), "edited");
}

// As Loosefit 0.1 wrote them: no mark, so nobody knows what has been changed since.
TEST_F(OutputSafety, ARunWithoutAMarkIsReadAndKept) {
  const std::string scenario = file("case.toml", kStopped);
  ASSERT_EQ(run(scenario).exit_code, 1);
  fs::remove(base / "out/.loosefit-output.json");
  const auto before = everything();
  expect_refused(run(scenario), "not an earlier output");
  EXPECT_EQ(everything(), before);
  const ProgramRun map = loosefit("map -q --allow-unsettled " + out);
  EXPECT_EQ(map.exit_code, 1) << map.output;
  EXPECT_NE(map.output.find("out/replaced-1"), std::string::npos) << map.output;
  EXPECT_TRUE(fs::exists(base / "out/sites.csv"));
  for (const auto& [name, content] : before) {
    const fs::path relative = fs::path(name).lexically_relative(out);
    if (fs::is_directory(name) || *relative.begin() == "..") continue;
    const bool replaced = fs::exists(base / "out/replaced-1" / relative);
    EXPECT_EQ(text((replaced ? "out/replaced-1" : "out") / relative), content) << relative;
  }
}

TEST_F(OutputSafety, AKilledRunLeavesTheOldOutputAndTheNextOneTidiesUp) {
  const std::string scenario = file("case.toml", kStopped);
  fs::create_directory(base / "real");
  fs::create_directory_symlink("real", base / "out");
  ASSERT_EQ(run(scenario).exit_code, 1);
  const auto before = everything();
  const std::string slow = file("slow.toml", "[simulation]\nedge_length = 0.005\n");
  run_program("timeout -s KILL 3 " + kLoosefit + " drape " + slow + " -o " + out);
  fs::remove(slow);
  const auto killed = everything();
  EXPECT_GT(killed.size(), before.size()) << "the hidden folder of a run that was killed";
  for (const auto& [name, content] : before) EXPECT_EQ(killed.at(name), content) << name;
  ASSERT_EQ(run(scenario).exit_code, 1);
  EXPECT_TRUE(fs::is_symlink(base / "out"));
  for (const auto& [name, content] : everything()) EXPECT_TRUE(before.count(name)) << name;
}

TEST_F(OutputSafety, OnAFullDiskBodyAndPatternLeaveTheOldFilesWhole) {
  const std::string body = "body --height 1.7 -o " + out;
  const std::string pattern = "pattern --size women-38 -o " + out;
  for (const std::string& command : {body, pattern}) {
    expect_refused(on_full_disk(4, command), "cannot");
    EXPECT_FALSE(fs::exists(out)) << "no truncated file, no folder";
  }
  for (const std::string& command : {body, pattern}) {
    const ProgramRun first = loosefit(command);
    ASSERT_EQ(first.exit_code, 0) << first.output;
  }
  const auto before = everything();
  expect_refused(on_full_disk(4, "body --height 1.8 -o " + out), "cannot");
  expect_refused(on_full_disk(4, "pattern --size men-M -o " + out), "cannot");
  EXPECT_EQ(everything(), before);
  EXPECT_EQ(loosefit("pattern --size men-M -o " + out).exit_code, 0);
  EXPECT_NE(text("out/pattern.json"), before.at(out + "/pattern.json"));
  EXPECT_EQ(text("out/body.obj"), before.at(out + "/body.obj"));

  file("out/pattern.svg", "drawn by hand");
  expect_refused(loosefit("pattern --size women-38 -o " + out), "pattern.svg: found");
  EXPECT_EQ(text("out/pattern.svg"), "drawn by hand");
}

TEST_F(OutputSafety, ValidationKeepsForeignFiles) {
  const std::string command = "validate --quick --only T1 -o " + out;
  ASSERT_EQ(loosefit(command).exit_code, 0);
  file("out/notes.txt", "mine");
  ASSERT_EQ(loosefit(command).exit_code, 0);
  EXPECT_EQ(text("out/notes.txt"), "mine");
  file("out/validation.html", "edited");
  expect_refused(loosefit(command), "validation.html: found");
  EXPECT_EQ(text("out/validation.html"), "edited");
}

TEST_F(OutputSafety, OutputThatDoesNotArriveIsNoSuccess) {
  for (const char* command : {"--help", "run --help", "--version", "version", "material list",
                              "material show wool", "validate --list", "pattern --list-sizes"}) {
    for (const char* nowhere : {" >/dev/full", " >&-"}) {
      const ProgramRun run = loosefit(std::string(command) + nowhere);
      EXPECT_EQ(run.exit_code, 2) << command << nowhere;
      EXPECT_EQ(run.output.rfind("error: standard output: cannot be written", 0), 0u)
          << command << nowhere << "\n"
          << run.output;
    }
  }
}

// A closed stream gives its number to the first file that is opened.
TEST_F(OutputSafety, NothingPrintedEndsUpInAFile) {
  ASSERT_EQ(loosefit("pattern --size women-38 -o " + out).exit_code, 0);
  const std::string closed = (base / "closed").string();
  EXPECT_EQ(loosefit("pattern --size women-38 -o " + closed + " >&- 2>&-").exit_code, 2);
  for (const char* name : {"pattern.json", "pattern.svg"})
    EXPECT_EQ(text(std::string("closed/") + name), text(std::string("out/") + name));
}

}  // namespace
}  // namespace loosefit
