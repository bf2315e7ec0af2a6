#include "loosefit/base/resources.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <cstdlib>
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

/// Ends the process with what it is told on this core alone.
[[noreturn]] void count_on(int cpu) {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(cpu, &one);
  if (sched_setaffinity(0, sizeof one, &one) != 0) std::_Exit(9);
  const ThreadLimit all(0);
  std::_Exit(10 * allowed_cores() + usable_threads());
}

TEST(AllowedCoresDeath, AreThoseOfTheAffinity) {
  cpu_set_t all;
  ASSERT_EQ(sched_getaffinity(0, sizeof all, &all), 0);
  EXPECT_LE(allowed_cores(), CPU_COUNT(&all));
  EXPECT_GE(allowed_cores(), 1);
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu)
    if (CPU_ISSET(cpu, &all)) {
      EXPECT_EXIT(count_on(cpu), ::testing::ExitedWithCode(11), "") << cpu;
    }
}

TEST(ThreadLimit, HasNoMoreThreadsThanAllowedCores) {
  const ThreadLimit many(10000);
  EXPECT_EQ(usable_threads(), allowed_cores());
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
