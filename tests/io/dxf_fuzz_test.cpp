#include <gtest/gtest.h>

#include <chrono>

#include "loosefit/base/error.h"
#include "loosefit/io/dxf/dxf_read.h"
#include "loosefit/pattern/pattern_check.h"
#include "support/dxf_text.h"
#include "support/fuzz_cases.h"
#include "support/mutate.h"

// Damaged DXF files: never a crash, never a hang; an error that says where, or a sound pattern.
namespace loosefit::io {
namespace {

TEST(DxfFuzz, ReaderRefusesWithAPlaceOrGivesSoundPanels) {
  const std::string valid = gerber_like_dxf();
  const unsigned cases = fuzz_cases(3000);
  unsigned refused = 0;
  const auto start = std::chrono::steady_clock::now();
  for (unsigned seed = 0; seed < cases; ++seed) {
    SCOPED_TRACE(seed);
    try {
      const PatternFile file = parse_dxf_pattern(Mutator(seed)(valid), "fuzz.dxf");
      pattern::check_pattern(file.pattern);
      // What is lost is told: three panels are in the file.
      EXPECT_TRUE(file.pattern.panels.size() >= 3 || file.warnings.size() > 1 ||
                  file.unused.size() > 2);
    } catch (const InvalidInput& error) {
      ++refused;
      const std::string message = error.what();
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      EXPECT_LT(message.size(), 900u) << message;
      EXPECT_EQ(message.rfind("fuzz.dxf:", 0), 0u) << message;
    }
  }
  EXPECT_GT(refused, cases / 3) << "the damage is real";
  EXPECT_LT(refused, cases) << "and some files survive it";
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  EXPECT_LT(spent.count(), 0.02 * cases + 10);
}

}  // namespace
}  // namespace loosefit::io
