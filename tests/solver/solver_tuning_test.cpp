#include "loosefit/solver/solver_tuning.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "loosefit/base/error.h"

namespace loosefit::solver {
namespace {

/// What is said about a tuning that `change` has spoilt.
template <class Change>
std::string complaint(const Change& change) {
  SolverTuning tuning;
  change(tuning);
  try {
    tuning.validate();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return {};
}

TEST(SolverTuning, IsValidAsItStandsAndNamesWhatIsOutOfRange) {
  EXPECT_EQ(complaint([](SolverTuning&) {}), "");
  const auto expect_named = [](const std::string& text, const char* name) {
    EXPECT_NE(text.find(name), std::string::npos) << text;
  };
  expect_named(complaint([](SolverTuning& t) { t.search.armijo = -1; }), "search.armijo");
  expect_named(complaint([](SolverTuning& t) { t.region.search.max_backtracks = 0; }),
               "max_backtracks");
  expect_named(complaint([](SolverTuning& t) { t.quasi_static.max_dt = 1; }), "max_dt");
  expect_named(complaint([](SolverTuning& t) { t.matrix.max_regularisations = -1; }),
               "max_regularisations");
  expect_named(complaint([](SolverTuning& t) { t.precision.accuracy = std::nan(""); }),
               "precision.accuracy");
}

}  // namespace
}  // namespace loosefit::solver
