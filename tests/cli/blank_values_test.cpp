#include <gtest/gtest.h>

#include <filesystem>

#include "loosefit/io/text_file.h"
#include "support/program_output.h"
#include "support/scratch_folder.h"

// A name that is empty or blank is refused at every door, before anything is done or written.
namespace loosefit {
namespace fs = std::filesystem;
namespace {

struct BlankValues : ::testing::Test {
  const support::ScratchFolder base;
  void SetUp() override {
    io::write_text_file((base / "case.toml").string(), "[simulation]\nedge_length = 0.05\n");
    io::write_text_file((base / "study.toml").string(),
                        "[study]\nname = \"small\"\nbase = \"case.toml\"\n[[axis]]\nname = \"h\"\n"
                        "key = \"body.height\"\nvalues = [1.6, 1.7]\n");
  }
  ProgramRun here(const std::string& arguments) const {
    return run_program("bash -c 'cd " + base.string() + "; timeout 60 " + LOOSEFIT_BINARY + " " +
                       arguments + "'");
  }
};

TEST_F(BlankValues, OfAnOutputAreRefusedByEveryCommand) {
  const char* const commands[] = {"run case.toml",         "drape case.toml",
                                  "body --height 1.7",     "pattern --pattern t-shirt",
                                  "rank case.toml -m ecg", "render .",
                                  "study plan study.toml", "study run study.toml",
                                  "study report .",        "study export .",
                                  "study compare . .",     "validate --list"};
  const char* const forms[] = {"-o \"\"", "-o \"  \"", "--output \"\"", "--output \"\t\"",
                               "--output="};
  for (const std::string command : commands)
    for (const std::string form : forms) {
      const ProgramRun run = here(command + " " + form);
      EXPECT_EQ(run.exit_code, 2) << command << " " << form << "\n" << run.output;
      EXPECT_NE(run.output.find("--output"), std::string::npos) << run.output;
    }
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(base)) files += entry.is_regular_file();
  EXPECT_EQ(files, 2u) << "nothing was written";
}

TEST_F(BlankValues, OfAnInputAreRefusedToo) {
  for (const std::string arguments :
       {"run \"\" -o out", "pattern --file \"\"", "pattern --size \"\"", "pattern --seams \" \"",
        "body --file \"\"", "setup --to \"\"", "setup --from \"\"", "study status \"\"",
        "schema --check \"\""}) {
    const ProgramRun run = here(arguments);
    EXPECT_EQ(run.exit_code, 2) << arguments << "\n" << run.output;
  }
}

TEST_F(BlankValues, ValuesOfABodyHaveTheRangesOfAScenario) {
  struct Value {
    const char *option, *key;
    double value;
  };
  const Value values[] = {{"--height", "body.height", 0.69},
                          {"--age", "body.age", 2.9},
                          {"--muscle", "body.muscle", 1.01},
                          {"--chest", "body.measurements.chest", 1.81},
                          {"--wrist", "body.measurements.wrist", 0.069},
                          {"--sex", "body.sex", 1.5},
                          {"--arm-abduction-deg", "body.posture.arm_abduction_deg", 4.9},
                          {"--forward-bend-deg", "body.posture.forward_bend_deg", -21},
                          {"--sitting", "body.posture.sitting", 1.2}};
  for (const Value& v : values) {
    const std::string text = std::to_string(v.value);
    const ProgramRun option = here("body " + std::string(v.option) + " " + text);
    EXPECT_EQ(option.exit_code, 2) << v.option << option.output;
    io::write_text_file((base / "own.toml").string(), std::string(v.key) + " = " + text + "\n");
    const ProgramRun key = here("schema --check own.toml");
    EXPECT_EQ(key.exit_code, 2) << v.key << key.output;
    const std::size_t found = option.output.find("expected"), same = key.output.find("expected");
    ASSERT_NE(found, std::string::npos) << option.output;
    ASSERT_NE(same, std::string::npos) << key.output;
    const auto line = [](const std::string& from, std::size_t at) {
      return from.substr(at, from.find('\n', at) - at);
    };
    EXPECT_EQ(line(option.output, found), line(key.output, same)) << v.option;
  }
}

}  // namespace
}  // namespace loosefit
