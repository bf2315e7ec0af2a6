#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "loosefit/base/error.h"
#include "loosefit/io/scenario.h"
#include "loosefit/io/scenario_writer.h"
#include "loosefit/io/text_file.h"
#include "support/mutate.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"

// Damaged scenarios: never a crash, never a hang, one error that says where.
namespace loosefit {
namespace {

const char* const kValid = R"([body]
sex = "male"
age = 41
height = 1.80
measurements = { chest = 1.00, waist = 0.86, hip = 1.02 }
posture = { arm_abduction_deg = 20, forward_bend_deg = 12.5 }
dress_posture = "a-pose"
[garment]
pattern = "long-sleeve-shirt"
fit = { chest = 0.15, waist = 0.12, hip = 0.08, sleeve = 0.15, wrist = 0.2 }
[material]
name = "cotton-jersey"
bending_warp = 9e-6
[material.curve.warp]
elongation = [0.05, 0.2]
force = [3.0, 30.0]
[material.kes]
2HB = 0.03
[[attachment]]
kind = "board"
name = "logger"
panel = "back"
at = [0.0, -0.12]
size = [0.04, 0.03]
mass = 0.012
[[attachment]]
kind = "cable"
name = "lead"
panel = "back"
path = [[0.0, -0.15], [0.02, -0.40]]
linear_density = 0.004
[[site]]
name = "neck"
landmark = "c7"
[simulation]
edge_length = 0.012
integrator = "implicit-euler"
seed = 7
[output]
maps = ["distance"]
views = ["front", "left"]
)";

/// Empty when the text is a scenario, else the message.
std::string refusal(const std::string& text) {
  try {
    const std::string resolved = io::scenario_toml(io::parse_scenario(text, "fuzz.toml"));
    EXPECT_EQ(io::scenario_toml(io::parse_scenario(resolved, "fuzz.toml")), resolved) << text;
    return {};
  } catch (const Error& e) {
    return e.what();
  }
}

TEST(ScenarioFuzz, ParserRefusesWithAPlaceOrAccepts) {
  ASSERT_EQ(refusal(kValid), "");
  int refused = 0;
  const auto start = std::chrono::steady_clock::now();
  for (unsigned seed = 0; seed < 8000; ++seed) {
    SCOPED_TRACE(seed);
    const std::string message = refusal(Mutator(seed)(kValid));
    if (message.empty()) continue;
    ++refused;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_LT(message.size(), 700u) << message;
    EXPECT_EQ(message.rfind("fuzz.toml:", 0), 0u) << message;
    EXPECT_NE(message.find("expected"), std::string::npos) << message;
  }
  EXPECT_GT(refused, 4000) << "the damage is real";
  EXPECT_LT(refused, 8000) << "and some files survive it";
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  EXPECT_LT(spent.count(), 60);
}

TEST(ScenarioFuzz, ProgramEndsWithCodeTwoAndOneErrorLine) {
  namespace fs = std::filesystem;
  const support::ScratchFolder folder;
  int tried = 0;
  for (unsigned seed = 100; tried < 25; ++seed) {
    const std::string text = Mutator(seed)(kValid);
    if (refusal(text).empty()) continue;
    ++tried;
    const std::string file = (folder / "case.toml").string();
    io::write_text_file(file, text);
    const ProgramRun run = run_program(std::string(LOOSEFIT_BINARY) + " drape " + file + " -o " +
                                       (folder / "out").string());
    EXPECT_EQ(run.exit_code, 2) << "seed " << seed << "\n" << run.output;
    EXPECT_EQ(run.output.rfind("error: ", 0), 0u) << run.output;
    EXPECT_EQ(run.output.find("error: ", 1), std::string::npos) << run.output;
    EXPECT_FALSE(fs::exists(folder / "out"));
  }
}

}  // namespace
}  // namespace loosefit
