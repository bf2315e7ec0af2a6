#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "loosefit/io/text_file.h"
#include "support/program_output.h"
#include "support/scratch_folder.h"

// What the machine has not, the program tells in words, within seconds.
namespace loosefit {
namespace fs = std::filesystem;
namespace {

constexpr int kLoaderGaveUp = 127;  ///< too little for the libraries: the program has not begun

struct MachineLimits : ::testing::Test {
  const support::ScratchFolder base;
  void SetUp() override {
    io::write_text_file((base / "case.toml").string(),
                        "[garment]\npattern = \"tank-top\"\n[donning]\nmovements = []\n"
                        "[simulation]\nedge_length = 0.05\nmax_iterations = 30\n");
    io::write_text_file((base / "study.toml").string(),
                        "[study]\nname = \"small\"\nbase = \"case.toml\"\n[[axis]]\nname = \"h\"\n"
                        "key = \"body.height\"\nvalues = [1.6, 1.7]\n");
  }

  /// With so many KiB of address space, and at most a minute.
  ProgramRun within(int kilobytes, const std::string& arguments) const {
    return run_program("bash -c 'cd " + base.string() + "; ulimit -v " + std::to_string(kilobytes) +
                       "; exec timeout -k 1 60 " + LOOSEFIT_BINARY + " " + arguments + "'");
  }
};

TEST_F(MachineLimits, WantOfMemoryEndsInWords) {
  std::mt19937 random(18);
  for (const std::string arguments :
       {"pattern --pattern t-shirt", "body --height 1.7", "run case.toml -q --no-pictures -o run",
        "study run study.toml -q -o study"}) {
    for (int draw = 0; draw < 4; ++draw) {
      const int kilobytes = 200000 + static_cast<int>(random() % 6) * 100000;
      fs::remove_all(base / "run");
      fs::remove_all(base / "study");
      const ProgramRun run = within(kilobytes, arguments);
      if (run.exit_code == kLoaderGaveUp) continue;
      EXPECT_TRUE(run.exit_code >= 0 && run.exit_code <= 2)
          << arguments << " in " << kilobytes << " KiB: " << run.exit_code << "\n"
          << run.output;
      const bool told = run.output.find("not enough memory") != std::string::npos;
      EXPECT_TRUE(run.exit_code != 2 || told) << arguments << " in " << kilobytes << " KiB\n"
                                              << run.output;
      EXPECT_FALSE(run.exit_code == 2 && fs::exists(base / "run")) << kilobytes;
    }
  }
}

TEST_F(MachineLimits, CoresAreThoseThatTheAffinityAllows) {
  const ProgramOutput run = run_apart(base, "doctor --json", "taskset -c 0");
  EXPECT_EQ(run.document()["cores"], 1) << run.out;
  const ProgramOutput plan =
      run_apart(base, "study plan --json " + (base / "study.toml").string(), "taskset -c 0");
  EXPECT_EQ(plan.document()["workers"], 1) << plan.out;
}

}  // namespace
}  // namespace loosefit
