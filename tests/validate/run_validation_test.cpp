#include "loosefit/validate/run_validation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "loosefit/base/error.h"
#include "loosefit/validate/validation_table.h"
#include "support/artificial_benchmarks.h"

namespace loosefit::validate {
namespace {

using support::finding;
using support::with_findings;

TEST(FindingGates, RelativeAbsoluteAndReported) {
  EXPECT_TRUE(finding(200, 201.9, Finding::Gate::relative, 0.01).pass());
  EXPECT_FALSE(finding(200, 202.1, Finding::Gate::relative, 0.01).pass());
  EXPECT_DOUBLE_EQ(finding(-200, -202, Finding::Gate::relative, 0.01).error(), 0.01);
  EXPECT_TRUE(finding(41.5, 41.79, Finding::Gate::absolute, 0.3).pass());
  EXPECT_FALSE(finding(41.5, 41.81, Finding::Gate::absolute, 0.3).pass());
  EXPECT_TRUE(finding(1, 100, Finding::Gate::reported, 0).pass());
}

TEST(FindingGates, WhatIsNotANumberNeverPasses) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (const auto gate :
         {Finding::Gate::relative, Finding::Gate::absolute, Finding::Gate::reported})
      EXPECT_FALSE(finding(1, bad, gate, 1e9).pass());
  // Nothing is near an expected figure that does not exist.
  EXPECT_FALSE(finding(0, 1e-12, Finding::Gate::relative, 0.01).pass());
  EXPECT_FALSE(
      finding(std::numeric_limits<double>::quiet_NaN(), 1, Finding::Gate::relative, 1).pass());
}

TEST(RunValidation, CountsGatedBenchmarksAndNamesTheMissed) {
  Progress silent;
  const Validation v = run_validation(support::artificial_benchmarks(), Effort::full, silent, 2);
  ASSERT_EQ(v.outcomes.size(), 5u);
  EXPECT_TRUE(v.outcomes[0].pass());
  EXPECT_FALSE(v.outcomes[1].pass()) << "one finding out of two misses";
  EXPECT_FALSE(v.outcomes[2].gated());
  EXPECT_TRUE(v.outcomes[2].pass());
  EXPECT_EQ(v.outcomes[3].error, "the loom broke");
  EXPECT_TRUE(v.outcomes[3].gated());
  EXPECT_FALSE(v.outcomes[4].pass()) << "a benchmark that finds nothing proves nothing";
  EXPECT_FALSE(v.pass());
  EXPECT_EQ(verdict_line(v), "1 of 4 gated benchmarks pass; missed: A2, A4, A5");
}

TEST(RunValidation, PassesWhenAllGatesAreMet) {
  Progress silent;
  const auto all = support::artificial_benchmarks();
  const Validation v = run_validation({all[0], all[2]}, Effort::full, silent, 1);
  EXPECT_TRUE(v.pass());
  EXPECT_EQ(verdict_line(v), "1 of 1 gated benchmarks pass");
}

TEST(RunValidation, TellsInTheOrderOfTheListWhateverTheWorkers) {
  for (const int workers : {1, 2, 5}) {
    Progress silent;
    std::string order;
    run_validation(support::artificial_benchmarks(), Effort::full, silent, workers,
                   [&](const BenchmarkOutcome& o) { order += o.id; });
    EXPECT_EQ(order, "A1A2A3A4A5") << workers;
  }
}

TEST(RunValidation, StopsWhenAsked) {
  Progress progress;
  int told = 0;
  Benchmark first = with_findings("A1", {finding(1, 1, Finding::Gate::relative, 0.1)});
  const auto inner = first.run;
  first.run = [&](Effort e, Progress& p) {
    progress.request_cancel();  // Ctrl-C while the first one runs
    p.check_cancelled();
    return inner(e, p);
  };
  EXPECT_THROW(run_validation({first, first, first}, Effort::full, progress, 2,
                              [&](const BenchmarkOutcome&) { ++told; }),
               Cancelled);
  EXPECT_EQ(told, 0);
}

TEST(SelectBenchmarks, TakesIdsInAnyCaseAndKeepsTheOrder) {
  const auto all = support::artificial_benchmarks();
  const auto chosen = select_benchmarks(all, {"a3", "A1"}, Effort::full);
  ASSERT_EQ(chosen.size(), 2u);
  EXPECT_EQ(chosen[0].id, "A1");
  EXPECT_EQ(chosen[1].id, "A3");
  EXPECT_EQ(select_benchmarks(all, {}, Effort::full).size(), 5u);
  EXPECT_EQ(select_benchmarks(all, {}, Effort::quick).size(), 4u) << "A5 has no quick form";
}

TEST(SelectBenchmarks, RefusesWhatItDoesNotKnow) {
  const auto all = support::artificial_benchmarks();
  EXPECT_THROW(select_benchmarks(all, {"A1", "Z9"}, Effort::full), InvalidInput);
  EXPECT_THROW(select_benchmarks(all, {"A5"}, Effort::quick), InvalidInput);
  EXPECT_NO_THROW(select_benchmarks(all, {"A5"}, Effort::full));
}

TEST(Catalogue, IdsAreUniqueAndEveryEntrySaysWhereItsFiguresComeFrom) {
  std::vector<std::string> ids;
  for (const Benchmark& b : benchmarks()) {
    EXPECT_EQ(std::count(ids.begin(), ids.end(), b.id), 0) << b.id;
    ids.push_back(b.id);
    EXPECT_FALSE(b.title.empty()) << b.id;
    EXPECT_FALSE(b.reference.empty()) << b.id;
    EXPECT_TRUE(b.run) << b.id;
  }
}

}  // namespace
}  // namespace loosefit::validate
