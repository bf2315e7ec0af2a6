#include "loosefit/solver/linear/multifrontal/kernel_seat.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <new>
#include <thread>
#include <vector>

#include "loosefit/solver/linear/multifrontal/dense_kernels.h"

namespace loosefit::solver::dense {
namespace {

constexpr std::size_t kMegabyte = 1 << 20;

/// Address space that this process has taken.
std::size_t taken() {
  std::size_t pages = 0;
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  if (!file || std::fscanf(file, "%zu", &pages) != 1) pages = 0;
  if (file) std::fclose(file);
  return pages * 4096;
}

void leave_only(std::size_t bytes) {
  const rlimit limit{taken() + bytes, taken() + bytes};
  if (setrlimit(RLIMIT_AS, &limit) != 0) std::_Exit(9);
}

/// b ← b L⁻ᵀ with L twice the identity, of a size for which OpenBLAS asks for its memory.
bool divides_right() {
  constexpr int n = 96;
  std::vector<double> l(n * n, 0.0), b(n * n, 3.0);
  for (int i = 0; i < n; ++i) l[i * n + i] = 2;
  divide_rows(l.data(), n, b.data(), n, n);
  return std::all_of(b.begin(), b.end(), [](double x) { return x == 1.5; });
}

[[noreturn]] void call_with(std::size_t bytes) {
  leave_only(bytes);
  try {
    std::_Exit(divides_right() ? 0 : 3);
  } catch (const std::bad_alloc&) {
    std::_Exit(2);
  }
}

[[noreturn]] void call_from_many_threads_with(std::size_t bytes) {
  std::vector<std::thread> threads;
  std::vector<char> right(6, 0);
  leave_only(bytes + 6 * 80 * kMegabyte);  // stacks and heaps of the threads
  for (std::size_t t = 0; t < right.size(); ++t)
    threads.emplace_back([&right, t] {
      bool all = true;
      for (int k = 0; k < 50; ++k) all = all && divides_right();
      right[t] = all;
    });
  for (std::thread& thread : threads) thread.join();
  std::_Exit(std::count(right.begin(), right.end(), 1) == 6 ? 0 : 3);
}

struct KernelSeatDeath : ::testing::Test {
  void SetUp() override {
    if (taken() > std::size_t(1) << 40) GTEST_SKIP() << "a sanitizer has taken all addresses";
    GTEST_FLAG_SET(death_test_style, "threadsafe");
  }
};

TEST_F(KernelSeatDeath, WithoutMemoryForACallThereIsAnErrorAndNoWaitingForIt) {
  for (const std::size_t megabytes : {8, 40, 100})
    EXPECT_EXIT(call_with(megabytes * kMegabyte), ::testing::ExitedWithCode(2), "") << megabytes;
  EXPECT_EXIT(call_with(400 * kMegabyte), ::testing::ExitedWithCode(0), "");
}

TEST_F(KernelSeatDeath, ThreadsTakeTurnsWhereThereIsMemoryForAFewCalls) {
  EXPECT_EXIT(call_from_many_threads_with(200 * kMegabyte), ::testing::ExitedWithCode(0), "");
}

TEST(KernelSeat, AreAsManyAsThreadsAskFor) {
  std::vector<std::thread> threads;
  std::vector<char> right(8, 0);
  for (std::size_t t = 0; t < right.size(); ++t)
    threads.emplace_back([&right, t] { right[t] = divides_right(); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(std::count(right.begin(), right.end(), 1), 8);
}

}  // namespace
}  // namespace loosefit::solver::dense
