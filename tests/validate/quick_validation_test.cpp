#include <gtest/gtest.h>

#include <algorithm>

#include "loosefit/validate/run_validation.h"
#include "loosefit/validate/validation_table.h"

// The quick form of every benchmark, one test each, so that they run side by side.
namespace loosefit::validate {
namespace {

class QuickValidation : public ::testing::TestWithParam<std::string> {};

TEST_P(QuickValidation, MeetsItsGatesOrMissesThemAsStated) {
  Progress silent;
  const auto chosen = select_benchmarks(benchmarks(), {GetParam()}, Effort::quick);
  const Validation validation = run_validation(chosen, Effort::quick, silent, 1);
  EXPECT_TRUE(validation.as_stated()) << outcome_table(validation.outcomes.at(0));
  EXPECT_TRUE(validation.outcomes.at(0).gated()) << "nothing here could fail";
}

std::vector<std::string> quick_ids() {
  std::vector<std::string> ids;
  for (const Benchmark& b : select_benchmarks(benchmarks(), {}, Effort::quick)) ids.push_back(b.id);
  return ids;
}

INSTANTIATE_TEST_SUITE_P(All, QuickValidation, ::testing::ValuesIn(quick_ids()),
                         [](const auto& tested) {
                           std::string id = tested.param;  // "AG1-4": no hyphens in a name
                           std::replace(id.begin(), id.end(), '-', '_');
                           return id;
                         });

}  // namespace
}  // namespace loosefit::validate
