#include "loosefit/validate/run_validation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <regex>

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

Finding known(double obtained) {
  Finding f = finding(1, obtained, Finding::Gate::relative, 0.01);
  f.known_miss = KnownMiss{0.05, "the cloth is too stiff"};
  return f;
}

TEST(FindingGates, AKnownMissIsNoticedWhenItPassesOrMissesByMoreThanStated) {
  EXPECT_EQ(known(1.04).verdict(), Verdict::known_miss);
  EXPECT_EQ(known(0.96).verdict(), Verdict::known_miss);
  EXPECT_EQ(known(1.06).verdict(), Verdict::miss);
  EXPECT_EQ(known(1.009).verdict(), Verdict::unexpected_pass);
  EXPECT_EQ(known(std::numeric_limits<double>::quiet_NaN()).verdict(), Verdict::miss);
}

TEST(FindingGates, ARangeMayBeOpenAtOneEnd) {
  constexpr double kOpen = HUGE_VAL;
  const auto ranged = [](double obtained, double low, double high) {
    return in_range("ratio", "", std::nan(""), obtained, low, high, "");
  };
  EXPECT_TRUE(ranged(1.02, 0, 1.02).pass());
  EXPECT_FALSE(ranged(1.03, 0, 1.02).pass());
  EXPECT_NEAR(ranged(1.05, 0, 1.02).error(), 0.03, 1e-12);
  EXPECT_NEAR(ranged(-0.05, 0, 1.02).error(), 0.05, 1e-12);
  EXPECT_TRUE(ranged(7, 2, kOpen).pass());
  EXPECT_FALSE(ranged(1.9, 2, kOpen).pass());
  EXPECT_FALSE(ranged(kOpen, 2, kOpen).pass()) << "infinity is no figure";
  EXPECT_FALSE(ranged(0.26, -kOpen, 0.25).pass());
  EXPECT_DOUBLE_EQ(ranged(0.5, 0, 2).share_of_gate(), 0.5);
  EXPECT_DOUBLE_EQ(ranged(2, 2, kOpen).share_of_gate(), 1);
  EXPECT_LT(ranged(3, 2, kOpen).share_of_gate(), 1);
  EXPECT_GT(ranged(0.3, -kOpen, 0.25).share_of_gate(), 1);
  EXPECT_EQ(gate_text(ranged(1, 0, 1.02)), "0 to 1.02");
  EXPECT_EQ(gate_text(ranged(1, 2, kOpen)), "at least 2");
}

TEST(FindingGates, ACountThatIsKnownToBeWrongCanStillMiss) {
  EXPECT_EQ(whole_count("pairs", 4, 4, "").verdict(), Verdict::pass);
  EXPECT_EQ(whole_count("pairs", 4, 3, "").verdict(), Verdict::miss);
  const auto folded = [](int obtained) {
    return whole_count("pairs", 4, obtained, "", 2, "a fold").verdict();
  };
  EXPECT_EQ(folded(4), Verdict::unexpected_pass);
  EXPECT_EQ(folded(2), Verdict::known_miss);
  EXPECT_EQ(folded(1), Verdict::miss);
  EXPECT_NO_THROW(whole_count("pairs", 4, 2, "", 3, "a fold"));
  EXPECT_THROW(whole_count("pairs", 4, 2, "", 4, "a fold"), Error) << "0 of 4 would be no miss";
}

TEST(RunValidation, KnownMissesStandBesideTheOthersAndUnexpectedPassesAreNamed) {
  Progress silent;
  const Finding good = finding(1, 1, Finding::Gate::relative, 0.01);
  const Validation v =
      run_validation({with_findings("K1", {good, known(1.03)}), with_findings("K2", {good})},
                     Effort::full, silent, 1);
  EXPECT_TRUE(v.as_stated());
  EXPECT_EQ(verdict_line(v), "1 of 2 gated benchmarks pass; known misses: K1");
  const std::string table = outcome_table(v.outcomes[0]);
  EXPECT_NE(table.find("K1 Artificial: known miss"), std::string::npos) << table;
  EXPECT_NE(table.find("known to miss by up to 5 %: the cloth is too stiff"), std::string::npos)
      << table;
  const Validation stale =
      run_validation({with_findings("K1", {known(1.001)})}, Effort::full, silent, 1);
  EXPECT_FALSE(stale.as_stated());
  EXPECT_EQ(verdict_line(stale), "0 of 1 gated benchmarks pass; stated to miss, but pass: K1");
}

TEST(RunValidation, CountsGatedBenchmarksAndNamesTheMissed) {
  Progress silent;
  const Validation v = run_validation(support::artificial_benchmarks(), Effort::full, silent, 2);
  ASSERT_EQ(v.outcomes.size(), 5u);
  EXPECT_EQ(v.outcomes[0].verdict(), Verdict::pass);
  EXPECT_EQ(v.outcomes[1].verdict(), Verdict::miss) << "one finding out of two misses";
  EXPECT_FALSE(v.outcomes[2].gated());
  EXPECT_EQ(v.outcomes[2].verdict(), Verdict::reported);
  EXPECT_EQ(v.outcomes[3].error, "the loom broke");
  EXPECT_TRUE(v.outcomes[3].gated());
  EXPECT_EQ(v.outcomes[4].verdict(), Verdict::miss)
      << "a benchmark that finds nothing proves nothing";
  EXPECT_FALSE(v.as_stated());
  EXPECT_EQ(verdict_line(v), "1 of 4 gated benchmarks pass; missed: A2, A4, A5");
}

TEST(RunValidation, PassesWhenAllGatesAreMet) {
  Progress silent;
  const auto all = support::artificial_benchmarks();
  const Validation v = run_validation({all[0], all[2]}, Effort::full, silent, 1);
  EXPECT_TRUE(v.as_stated());
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

std::string document(const std::string& path) {
  std::ifstream file(std::string(LOOSEFIT_SOURCE_DIR) + "/" + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

// The list of theory with its gates, and the table of results: what is told is what runs.
TEST(Catalogue, EveryBenchmarkStandsInTheListOfTheoryAndEveryResultIsThatOfOne) {
  const std::string theory = document("docs/theory/validation.md");
  const std::string list = theory.substr(0, theory.find("\n## 1 "));
  std::map<std::string, std::string> titles;
  for (const Benchmark& b : benchmarks()) {
    EXPECT_TRUE(titles.emplace(b.id, b.title).second) << b.id << " twice";
    EXPECT_TRUE(std::regex_search(list, std::regex("\\b" + b.id + "\\b"))) << b.id;
  }
  std::string results = document("docs/accuracy.md");
  results.erase(0, results.find("<!-- benchmarks: begin -->"));
  results.erase(0, results.find("| id |"));  // past the version that found them
  results.resize(std::min(results.size(), results.find("\n\n")));  // the first table
  const std::regex row(R"(\| ([A-Z]+[0-9]*(?:-[0-9]+)?) \| ([^|]*) \| [0-9]+ \|)");
  int rows = 0;
  for (std::sregex_iterator at(results.begin(), results.end(), row), end; at != end; ++at, ++rows)
    EXPECT_EQ((*at)[2].str(), titles[(*at)[1].str()]) << (*at)[1];
  EXPECT_GT(rows, 20);
}

}  // namespace
}  // namespace loosefit::validate
