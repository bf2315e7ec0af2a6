#include <gtest/gtest.h>

#include <filesystem>

#include "loosefit/io/text_file.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"
#include "support/trunk_tubes.h"

// The contract of the command line: exit codes, one error line with a place, folders left alone.
namespace loosefit {
namespace fs = std::filesystem;
namespace {

struct CommandLine : ::testing::Test {
  const support::ScratchFolder base;
  std::string file(const std::string& name, const std::string& text) const {
    io::write_text_file((base / name).string(), text);
    return (base / name).string();
  }
  static ProgramRun loosefit(const std::string& arguments, const std::string& environment = {}) {
    return run_program("env " + environment + " " + LOOSEFIT_BINARY + " " + arguments);
  }
};

void expect_refused(const ProgramRun& run, const std::string& phrase) {
  EXPECT_EQ(run.exit_code, 2) << run.output;
  const bool first_line = run.output.rfind("error: ", 0) == 0;  // else after progress lines
  EXPECT_TRUE(first_line || run.output.find("\nerror: ") != std::string::npos) << run.output;
  EXPECT_NE(run.output.find(phrase), std::string::npos) << run.output;
}

TEST_F(CommandLine, HelpAndVersionSucceed) {
  EXPECT_EQ(loosefit("--help").exit_code, 0);
  EXPECT_EQ(loosefit("run --help").exit_code, 0);
  const ProgramRun run = loosefit("version");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.output.find("cholmod"), std::string::npos) << run.output;
}

TEST_F(CommandLine, WrongUsageIsCodeTwo) {
  expect_refused(loosefit(""), "subcommand");
  expect_refused(loosefit("dance"), "");
  expect_refused(loosefit("run"), "");
  expect_refused(loosefit("run a b c -o d"), "");
}

TEST_F(CommandLine, AGarmentThatIsNotWornIsCodeOneAndNamedInWords) {
  file("tube.json", support::tube_file(56, 56, 22, 50));
  const std::string scenario = file(
      "case.toml", "[body]\nsex = \"female\"\nage = 30\nheight = 1.68\n[garment]\npattern = \"" +
                       (base / "tube.json").string() +
                       "\"\n[output]\npreset_sites = false\n[simulation]\n"
                       "edge_length = 0.04\ntime_budget = 60\n");
  const std::string out = (base / "out").string(),
                    words = "the waistband has slid to ";  // a tube wider than the hips
  const ProgramRun run = loosefit("run " + scenario + " -o " + out + " --no-pictures");
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_NE(run.output.find("\nsettled:"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("NOT WORN: " + words), std::string::npos) << run.output;
  for (const char* name : {"log.jsonl", "report.html", "summary.json"})
    EXPECT_NE(io::read_text_file(out + "/" + name, 50000000).find(words), std::string::npos)
        << name;
  EXPECT_FALSE(fs::exists(out + "/sites.csv"));
  const ProgramRun rank = loosefit("rank " + out + " -m imu-inclination");
  EXPECT_NE(rank.exit_code, 0);
  EXPECT_NE(rank.output.find(words), std::string::npos) << rank.output;
  EXPECT_EQ(loosefit("map " + out + " --allow-unsettled").exit_code, 1);
  EXPECT_TRUE(fs::exists(out + "/sites.csv"));
}

TEST_F(CommandLine, MissingScenarioFile) {
  expect_refused(loosefit("drape nowhere.toml -o " + (base / "out").string()), "no such file");
  EXPECT_FALSE(fs::exists(base / "out"));
}

TEST_F(CommandLine, ErrorNamesFileLineKeyAndGuess) {
  const std::string scenario = file("case.toml", "[body]\n\nheigth = 1.7\n");
  const ProgramRun run = loosefit("drape " + scenario + " -o " + (base / "out").string());
  expect_refused(run, "case.toml:3: body.heigth: found");
  EXPECT_NE(run.output.find("hint: did you mean \"height\"?"), std::string::npos) << run.output;
}

TEST_F(CommandLine, ErrorsOfLaterStagesNameTheScenarioLine) {
  const auto refuse = [this](const std::string& scenario, const std::string& phrase) {
    expect_refused(
        loosefit("drape " + file("case.toml", scenario) + " -o " + (base / "out").string()),
        phrase);
    EXPECT_FALSE(fs::exists(base / "out"));
  };
  refuse("[body]\n\nmeasurements = { chest = 0.2 }\n",
         "case.toml:3: body.measurements.chest: found 0.2");
  refuse("[garment]\nfit = { sleeve_length = 0.25 }\n",
         "case.toml:2: garment.fit.sleeve_length: found 0.25");
  refuse("[[site]]\nname = \"s\"\nlandmark = \"c77\"\n", "case.toml:3: site[0].landmark: ");
  refuse(
      "[[attachment]]\nkind = \"board\"\nname = \"x\"\npanel = \"bak\"\nat = [0, 0]\n"
      "radius = 0.01\n",
      "case.toml:4: attachment[0].panel: found");
}

TEST_F(CommandLine, EndlessFilesAndEmptyNamesAreRefused) {
  expect_refused(loosefit("body --file /dev/zero"), "not a file");
  expect_refused(loosefit("drape /dev/zero -o " + (base / "out").string()), "not a file");
  expect_refused(loosefit("drape " + file("case.toml", "") + " -o ''"), "an empty text");
}

TEST_F(CommandLine, BodyAndPatternLeaveTheOutputOfARunAlone) {
  fs::create_directories(base / "run");
  file("run/summary.json", "{}");
  const std::string run = (base / "run").string();
  expect_refused(loosefit("body --height 1.7 -o " + run), "summary.json");
  expect_refused(loosefit("pattern --size women-38 -o " + run), "summary.json");
  EXPECT_FALSE(fs::exists(base / "run/body.vtp"));
  EXPECT_FALSE(fs::exists(base / "run/pattern.json"));
}

TEST_F(CommandLine, ForeignFolderStaysUntouched) {
  fs::create_directories(base / "thesis");
  file("thesis/chapter.tex", "dear");
  expect_refused(loosefit("drape " + file("case.toml", "") + " -o " + (base / "thesis").string()),
                 "not an earlier output");
  EXPECT_EQ(io::read_text_file((base / "thesis/chapter.tex").string(), 10), "dear");
}

TEST_F(CommandLine, ImpossibleWishNamesTheMeasure) {
  const std::string scenario =
      file("case.toml", "[body]\nheight = 1.4\nmeasurements = { chest = 1.9 }\n");
  expect_refused(loosefit("drape " + scenario + " -o " + (base / "out").string()), "chest");
}

TEST_F(CommandLine, MissingBodyDataTellsTheWay) {
  const ProgramRun run =
      loosefit("drape " + file("case.toml", "") + " -o " + (base / "out").string(),
               "LOOSEFIT_DATA=/nowhere/body.lfb");
  EXPECT_EQ(run.exit_code, 2) << run.output;
  EXPECT_NE(run.output.find("loosefit setup"), std::string::npos) << run.output;
  EXPECT_FALSE(fs::exists(base / "out"));
}

TEST_F(CommandLine, InterruptLeavesNothingBehind) {
  const std::string scenario = file("case.toml", "[simulation]\nedge_length = 0.005\n");
  // SIGINT after four seconds: the run is then in dress or settle.
  const ProgramRun run = run_program("timeout -s INT 4 " + std::string(LOOSEFIT_BINARY) +
                                     " drape " + scenario + " -o " + (base / "out").string());
  // `timeout` reports 124 when it had to signal and the program then ended.
  EXPECT_EQ(run.exit_code, 124) << run.output;
  EXPECT_NE(run.output.find("interrupted"), std::string::npos) << run.output;
  for (const auto& entry : fs::directory_iterator(base))
    EXPECT_EQ(entry.path().filename(), "case.toml");
}

// A drape that is stopped long before it settles: quick, and as deterministic as a whole one.
const char* const kStopped = "[simulation]\nedge_length = 0.05\nmax_iterations = 2\nthreads = 1\n";

TEST_F(CommandLine, UnsettledRunIsSealedAndReturnsOne) {
  const std::string out = (base / "out").string();
  const ProgramRun run =
      loosefit("run " + file("case.toml", kStopped) + " --no-pictures -o " + out);
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_NE(run.output.find("because the net force is "), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("hint: "), std::string::npos) << run.output;
  for (const char* name : {"summary.json", "drape.vtp", "body.vtp", "pattern.json", "scenario.toml",
                           "log.jsonl", "report.html"})
    EXPECT_TRUE(fs::exists(base / "out" / name)) << name;
  EXPECT_FALSE(fs::exists(base / "out/sites.csv")) << "sealed: no maps, no sites";
  expect_refused(loosefit("map " + out), "not settled");
  EXPECT_EQ(loosefit("map --allow-unsettled " + out).exit_code, 1);
  EXPECT_TRUE(fs::exists(base / "out/sites.csv"));
  EXPECT_TRUE(fs::exists(base / "out/report.html")) << "untouched files stay";
}

// As under nohup: the terminal goes, the run does not. Sent once the program catches signals.
TEST_F(CommandLine, ASignalThatIsIgnoredFromTheStartEndsNothing) {
  const std::string out = (base / "out").string();
  const ProgramRun run =
      run_program("sh -c 'trap \"\" HUP; " + std::string(LOOSEFIT_BINARY) + " run " +
                  file("case.toml", kStopped) + " --no-pictures -o " + out +
                  " & p=$!; for k in $(seq 1000); do "
                  "grep -q \"SigCgt:.*[4-7c-f]...$\" /proc/$p/status && break; sleep 0.01; done; "
                  "kill -HUP $p || exit 99; wait $p'");
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_EQ(run.output.find("interrupted"), std::string::npos) << run.output;
  EXPECT_TRUE(fs::exists(base / "out/summary.json"));
}

TEST_F(CommandLine, RankWritesItsFilesBesideTheRunAndRefusesTheRest) {
  const std::string out = (base / "out").string();
  const std::string text = std::string(kStopped) +
                           "[[site]]\nname = \"spine\"\nlandmark = \"mid_back\"\n"
                           "[output]\npreset_sites = false\n"
                           "[ranking]\nmodality = \"imu-uncalibrated\"\n";
  const ProgramRun run =
      loosefit("run " + file("case.toml", text) + " --no-pictures --allow-unsettled -o " + out);
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_NE(run.output.find("Inertial sensor for inclination"), std::string::npos) << run.output;
  EXPECT_TRUE(fs::exists(base / "out/ranking-imu-uncalibrated.csv"));
  EXPECT_TRUE(fs::exists(base / "out/sewing-plan-imu-uncalibrated.svg"));

  expect_refused(loosefit("rank " + out + " -m temperature"), "out: the drape is not settled");
  const ProgramRun rank = loosefit("rank " + out + " -m temperature --allow-unsettled");
  EXPECT_EQ(rank.exit_code, 1) << rank.output;
  EXPECT_NE(rank.output.find("spine"), std::string::npos) << rank.output;
  for (const char* name : {"ranking-temperature.csv", "ranking-temperature.json",
                           "sewing-plan-temperature.svg", "ranking-imu-uncalibrated.json"})
    EXPECT_TRUE(fs::exists(base / "out" / name)) << name;
  expect_refused(loosefit("rank " + out + " -m temprature"), "did you mean \"temperature\"?");
  expect_refused(loosefit("rank " + out + " " + out + "/ -m temperature"), "every run once");
  expect_refused(loosefit("rank " + base.string() + " -m temperature"), "no earlier output");
}

// The resolved scenario with another number of threads gives the same drape, bit for bit.
TEST_F(CommandLine, SameBitsFromTheResolvedScenarioOnTwoThreads) {
  const std::string first = (base / "first").string(), second = (base / "second").string();
  loosefit("drape " + file("case.toml", kStopped) + " -o " + first);
  std::string resolved = io::read_text_file(first + "/scenario.toml", 100000);
  const std::size_t threads = resolved.find("threads = 1");
  ASSERT_NE(threads, std::string::npos) << resolved;
  resolved.replace(threads, 11, "threads = 2");
  loosefit("drape " + file("again.toml", resolved) + " -o " + second);
  EXPECT_EQ(io::read_text_file(first + "/drape.vtp", 100000000),
            io::read_text_file(second + "/drape.vtp", 100000000));
  EXPECT_EQ(io::read_text_file(second + "/scenario.toml", 100000), resolved);
}

// A file size limit behaves like a full disk: writing fails half-way through a file.
TEST_F(CommandLine, FullDiskIsOneErrorAndLeavesNothing) {
  const std::string scenario = file("case.toml", kStopped);
  const ProgramRun run =
      run_program("bash -c \"trap '' XFSZ; ulimit -f 100; " + std::string(LOOSEFIT_BINARY) +
                  " drape " + scenario + " -o " + (base / "out").string() + "\"");
  expect_refused(run, "out");
  for (const auto& entry : fs::directory_iterator(base))
    EXPECT_EQ(entry.path().filename(), "case.toml");
}

TEST_F(CommandLine, MaterialsAreListedWithTheirSource) {
  const ProgramRun list = loosefit("material list");
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_NE(list.output.find("paper-cotton-literal"), std::string::npos) << list.output;
  EXPECT_NE(loosefit("material show wool").output.find("source:"), std::string::npos);
  expect_refused(loosefit("material show wol"), "");
  const std::string wool = loosefit("material show wool-measured").output;
  for (const char* told : {"bending length: warp 16.5 mm", "HB/B after a tight bend: warp 24.6 1/m",
                           "0.067 gf cm2/cm    = 6.57046e-06 N m", "initial 365.6, to 5 % 2487"})
    EXPECT_NE(wool.find(told), std::string::npos) << told << " in\n" << wool;
}

TEST_F(CommandLine, ValidateListsRefusesAndReports) {
  const ProgramRun list = loosefit("validate --list");
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_NE(list.output.find("B1"), std::string::npos) << list.output;
  const ProgramRun unknown = loosefit("validate --only B1,BB4");
  expect_refused(unknown, "--only: found \"BB4\"");
  EXPECT_NE(unknown.output.find("did you mean"), std::string::npos) << unknown.output;

  const std::string out = (base / "out").string();
  const ProgramRun run = loosefit("validate --quick --only t1 -o " + out);
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_NE(run.output.find("1 of 1 gated benchmarks pass"), std::string::npos) << run.output;
  EXPECT_TRUE(fs::exists(base / "out/validation.json"));
  EXPECT_TRUE(fs::exists(base / "out/validation.html"));
  EXPECT_EQ(loosefit("validate --quick --only T1 -o " + out).exit_code, 0) << "replaces its own";
  fs::create_directories(base / "run");
  file("run/summary.json", "{}");
  expect_refused(loosefit("validate --only T1 -o " + (base / "run").string()), "validation.json");
}

TEST_F(CommandLine, InterruptedValidationLeavesNothingBehind) {
  const ProgramRun run = run_program("timeout -s INT 2 " + std::string(LOOSEFIT_BINARY) +
                                     " validate -o " + (base / "out").string());
  EXPECT_EQ(run.exit_code, 124) << run.output;
  EXPECT_NE(run.output.find("interrupted"), std::string::npos) << run.output;
  EXPECT_TRUE(fs::is_empty(base));
}

TEST_F(CommandLine, SlipsInCommandsAndOptionsGetAGuess) {
  const auto guess = [](const std::string& arguments, const std::string& name) {
    const ProgramRun run = loosefit(arguments);
    expect_refused(run, "found \"");
    EXPECT_NE(run.output.find("hint: did you mean \"" + name + "\"?"), std::string::npos)
        << run.output;
  };
  guess("rnu", "run");
  guess("material lsit", "list");
  guess("run case.toml --ouput out", "--output");
  guess("run case.toml -o out --no-picture", "--no-pictures");
  guess("pattern --fit-chets=0.3", "--fit-chest");
  const ProgramRun far = loosefit("dance");
  EXPECT_NE(far.output.find("hint: known: run, drape"), std::string::npos) << far.output;
}

TEST_F(CommandLine, NamesNeverReachTheTerminalRaw) {
  expect_refused(run_program("bash -c \"" + std::string(LOOSEFIT_BINARY) + " $'dance\\x1b[31m'\""),
                 "dance\\x1b[31m");
  for (const std::string& key :
       {std::string("\"a\\u001b[31m\" = 1\n"),
        std::string("[body]\nfile = \"a\\u001b[2J\\nb.obj\"\n"),
        std::string("[[site]]\nname = \"\\u001b[2J\"\nlandmark = \"x\"\n")}) {
    const ProgramRun run =
        loosefit("drape " + file("case.toml", key) + " -o " + (base / "out").string());
    EXPECT_EQ(run.exit_code, 2) << run.output;
    EXPECT_EQ(run.output.find('\x1b'), std::string::npos) << run.output;
  }
}

}  // namespace
}  // namespace loosefit
