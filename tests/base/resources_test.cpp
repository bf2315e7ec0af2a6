#include "loosefit/base/resources.h"

#include <gtest/gtest.h>

#include <vector>

namespace loosefit {
namespace {

TEST(PeakMemory, RisesByWhatIsTouched) {
  const double before = peak_memory_mb();
  EXPECT_GT(before, 1);
  std::vector<char> block(300 * 1000 * 1000, 'x');
  EXPECT_GT(peak_memory_mb(), before + 200);
  EXPECT_EQ(block.back(), 'x');
}

TEST(UsableMemory, IsMoreThanThisProcessHasTaken) {
  EXPECT_GT(usable_memory_mb(), peak_memory_mb());
}

TEST(ThreadLimit, HoldsWhileItLives) {
  const int before = usable_threads();
  {
    const ThreadLimit one(1);
    EXPECT_EQ(usable_threads(), 1);
  }
  EXPECT_EQ(usable_threads(), before);
  const ThreadLimit none(0);
  EXPECT_EQ(usable_threads(), before);
}

}  // namespace
}  // namespace loosefit
