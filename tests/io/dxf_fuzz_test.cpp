#include <gtest/gtest.h>

#include <chrono>

#include "loosefit/base/error.h"
#include "loosefit/io/dxf/dxf_read.h"
#include "loosefit/pattern/pattern_check.h"
#include "support/dxf_text.h"
#include "support/fuzz_cases.h"
#include "support/fuzz_tally.h"
#include "support/mutate.h"
#include "support/sound_pieces.h"

// Damaged DXF files: never a crash, never a hang; an error that says where, or a sound pattern.
namespace loosefit::io {
namespace {

TEST(DxfFuzz, ReaderRefusesWithAPlaceOrGivesSoundPanels) {
  const std::string valid = gerber_like_dxf();
  const unsigned cases = fuzz_cases(3000);
  const std::string whole = pieces_text(parse_dxf_pattern(valid, "fuzz.dxf").pattern);
  FuzzTally tally("DXF", cases);
  const auto start = std::chrono::steady_clock::now();
  for (unsigned seed = 0; seed < cases; ++seed) {
    SCOPED_TRACE(seed);
    const std::string damaged = Mutator(seed)(valid);
    tally.begin();
    try {
      const PatternFile file = parse_dxf_pattern(damaged, "fuzz.dxf");
      pattern::check_pattern(file.pattern);
      EXPECT_EQ(wrong_pieces(file.pattern, 0.001 * largest_number(damaged)), "");
      // What is lost is told: three panels are in the file.
      EXPECT_TRUE(file.pattern.panels.size() >= 3 || file.warnings.size() > 1 ||
                  file.unused.size() > 2);
      tally.read(pieces_text(file.pattern) == whole);
    } catch (const InvalidInput& error) {
      tally.refuse();
      const std::string message = error.what();
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      EXPECT_LT(message.size(), 900u) << message;
      EXPECT_EQ(message.rfind("fuzz.dxf:", 0), 0u) << message;
    }
  }
  tally.expect_real_damage(1.0 / 3);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  EXPECT_LT(spent.count(), 0.02 * cases + 10);
}

}  // namespace
}  // namespace loosefit::io
