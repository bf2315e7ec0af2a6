#include <gtest/gtest.h>

#include <filesystem>

#include "loosefit/study/case_files.h"
#include "loosefit/study/load_case.h"
#include "loosefit/study/run_case.h"

namespace loosefit {
namespace {

/// Three drapes of a shirt on a mesh that settles in seconds.
CaseResult repeated_on(int threads) {
  const std::string text =
      "[[site]]\nname = \"mid\"\nlandmark = \"mid_back\"\n"
      "[output]\npreset_sites = false\nmaps = [\"distance\"]\n"
      "[simulation]\nedge_length = 0.04\nrepeats = 3\nthreads = " +
      std::to_string(threads) + "\n";
  Progress silent;
  return run_case(parse_scenario(text, "case.toml"), silent);
}

TEST(RepeatDrapes, SameSpreadSideBySideAsOneByOneAndAfterReadingTheRunAgain) {
  const CaseResult alone = repeated_on(1), beside = repeated_on(2);
  for (const char* key : {"maps.distance_mm.area_mean", "sites.mid.distance_mm"}) {
    ASSERT_TRUE(alone.repeats.contains(key)) << key;
    const Spread &a = alone.repeats.at(key), &b = beside.repeats.at(key);
    EXPECT_EQ(a.count, 3);
    EXPECT_GT(a.deviation, 0) << key;
    EXPECT_EQ(a.mean, b.mean) << key;
    EXPECT_EQ(a.deviation, b.deviation) << key;
  }
  const auto folder = std::filesystem::path(::testing::TempDir()) / "repeated-drapes";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  write_case_files(folder, beside);
  write_summary_file(folder, beside);
  Progress silent;
  const CaseResult again = load_case(folder, silent);
  ASSERT_EQ(again.repeats.size(), beside.repeats.size());
  for (const auto& [key, spread] : beside.repeats) {
    EXPECT_EQ(again.repeats.at(key).count, spread.count) << key;
    EXPECT_EQ(again.repeats.at(key).deviation, spread.deviation) << key;
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace loosefit
