// The form of release builds, whatever this build is; check_test.cpp has the other one.
#define LOOSEFIT_CHECKED 0
#include <gtest/gtest.h>

#include "loosefit/base/check.h"

namespace loosefit {
namespace {

/// A call that is not constant: only an assertion that evaluates nothing lets the function be one.
bool not_constant() { return false; }
constexpr int guarded(int value) {
  LOOSEFIT_ASSERT(not_constant());
  return value;
}
static_assert(guarded(7) == 7);

TEST(AssertionOfARelease, EvaluatesNothing) {
  int calls = 0;
  LOOSEFIT_ASSERT(++calls > 5);
  EXPECT_EQ(calls, 0);
  EXPECT_EQ(guarded(8), 8);
}

}  // namespace
}  // namespace loosefit
