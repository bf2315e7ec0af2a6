// The form of debug builds, whatever this build is; check_release_test.cpp has the other one.
#define LOOSEFIT_CHECKED 1
#include "loosefit/base/check.h"

#include <gtest/gtest.h>

#include <string>

#include "loosefit/base/error.h"

namespace loosefit {
namespace {

TEST(Assertion, SaysExpressionFileAndLineAndEndsTheProgram) {
  const int edges = 3;
  LOOSEFIT_ASSERT(edges == 3);
  EXPECT_DEATH(LOOSEFIT_ASSERT(edges == 4), "check_test.cpp:[0-9]+: assertion failed: edges == 4");
}

TEST(Assertion, EvaluatesItsExpressionOnceCommasIncluded) {
  int calls = 0;
  const auto larger = [&](int a, int b) { return ++calls, a > b; };
  LOOSEFIT_ASSERT(larger(2, 1));
  EXPECT_EQ(calls, 1);
}

TEST(Require, ThrowsWhatMustHoldWithFileAndLine) {
  require(true, "one is one");
  try {
    require(1 == 2, "one is two");
    FAIL();
  } catch (const InvalidInput&) {
    FAIL() << "not the user's mistake";
  } catch (const Error& e) {
    const std::string message = e.what();
    EXPECT_EQ(message.find("internal error: one is two does not hold ("), 0u) << message;
    EXPECT_NE(message.find("check_test.cpp:"), std::string::npos) << message;
    EXPECT_NE(e.hint().find("report"), std::string::npos);
  }
}

}  // namespace
}  // namespace loosefit
