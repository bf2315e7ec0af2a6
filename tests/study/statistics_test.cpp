#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "loosefit/study/bootstrap.h"
#include "loosefit/study/draws.h"
#include "loosefit/study/how_loose.h"
#include "loosefit/study/population_ranking.h"

// Against closed forms: order statistics, coverage, correlations, variance shares, greedy choice.
namespace loosefit::study {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<double> ladder(int n, double low, double high) {
  std::vector<double> values;
  for (int i = 0; i < n; ++i) values.push_back(low + (high - low) * i / (n - 1));
  return values;
}

TEST(RobustScore, CountsAsFarFromAboveAsFromBelow) {
  EXPECT_EQ(robust_index_from_above(1), 0u);
  EXPECT_EQ(robust_index_from_above(20), 19u) << "of 20 people the worst";
  EXPECT_EQ(robust_index_from_above(21), 19u);
  EXPECT_EQ(robust_index_from_above(100), 95u);
  // So does the 95th percentile of a ranking.
  const std::vector<double> twenty = ladder(20, 1, 20);
  EXPECT_EQ(rank_population({{"a", twenty}}, 0.5, {.resamples = 0}).at(0).p95, 20);
  EXPECT_TRUE(std::isnan(robust_from_above({})));
}

TEST(Bootstrap, CoversTheMeanOfANormalSample) {
  int covered = 0;
  constexpr int trials = 400, n = 40;
  for (int t = 0; t < trials; ++t) {
    Draws draws(1000 + t);
    std::vector<double> sample(n);
    for (double& value : sample) value = 3 + 2 * draws.normal();
    const Bounds bounds = bootstrap(n,
                                    [&](const std::vector<int>& draw) {
                                      double sum = 0;
                                      for (const int i : draw) sum += sample[i];
                                      return sum / n;
                                    },
                                    {.seed = static_cast<std::uint64_t>(t), .resamples = 400});
    covered += bounds.low <= 3 && 3 <= bounds.high;
  }
  // 90 %, less what a percentile interval loses with 40 values (about 1.5 %); ± 3 standard errors.
  EXPECT_GT(covered, 0.84 * trials);
  EXPECT_LT(covered, 0.94 * trials);
}

TEST(Bootstrap, IntervalOfTheMeanHasTheWidthOfTheStandardError) {
  Draws draws(5);
  constexpr int n = 400;
  std::vector<double> sample(n);
  double mean = 0, squares = 0;
  for (double& value : sample) {
    value = draws.normal();
    mean += value / n;
    squares += value * value / n;
  }
  const double error = std::sqrt((squares - mean * mean) / n);
  const Bounds bounds = bootstrap(n, [&](const std::vector<int>& draw) {
    double sum = 0;
    for (const int i : draw) sum += sample[i];
    return sum / n;
  });
  EXPECT_NEAR((bounds.high - bounds.low) / (2 * normal_quantile(0.95) * error), 1, 0.08);
}

TEST(DistributionFree, FiftyNinePeopleMakeNinetyFivePercent) {
  EXPECT_LT(worst_of_n_confidence(58, 0.95), 0.95);
  EXPECT_GE(worst_of_n_confidence(59, 0.95), 0.95);
  EXPECT_NEAR(worst_of_n_confidence(30, 0.90), 0.958, 0.0005);
}

TEST(RankCorrelation, IsThatOfTheRanksAlone) {
  const std::vector<double> x = {1, 2, 3, 4, 5};
  EXPECT_DOUBLE_EQ(rank_correlation(x, {1, 10, 100, 1000, 1e9}), 1);
  EXPECT_DOUBLE_EQ(rank_correlation(x, {5, 4, 3, 2, 1}), -1);
  // 1 − 6 Σ d² / (n (n² − 1)) with d² = 0, 1, 1, 1, 1.
  EXPECT_NEAR(rank_correlation(x, {1, 3, 2, 5, 4}), 1 - 6.0 * 4 / (5 * 24), 1e-15);
  // Equal values share their mean rank: Pearson of (1, 2, 3, 4) and (1.5, 1.5, 3.5, 3.5).
  EXPECT_NEAR(rank_correlation({1, 2, 3, 4}, {0, 0, 1, 1}), 4 / std::sqrt(5.0 * 4.0), 1e-15);
  EXPECT_NEAR(rank_correlation({1, 2, kNaN, 3, 4}, {1, 2, 9, 3, 4}), 1, 1e-15);
  EXPECT_TRUE(std::isnan(rank_correlation(x, {1, 1, 1, 1, 1})));
}

TEST(MainEffect, OfAnAdditiveDesignIsItsShareOfVariance) {
  // y = a_i + b_j + e with variances 9, 1 and 0.25 in a large crossed design.
  Draws draws(8);
  constexpr int levels = 40, repeats = 10;
  std::vector<double> a(levels), b(levels);
  const auto standardised = [&](std::vector<double>& v, double deviation) {
    double mean = 0, squares = 0;
    for (double& value : v) mean += (value = draws.normal()) / levels;
    for (double& value : v) squares += (value - mean) * (value - mean) / levels;
    for (double& value : v) value = (value - mean) / std::sqrt(squares) * deviation;
  };
  standardised(a, 3);
  standardised(b, 1);
  std::vector<int> in_a, in_b;
  std::vector<double> y;
  for (int i = 0; i < levels; ++i)
    for (int j = 0; j < levels; ++j)
      for (int k = 0; k < repeats; ++k) {
        in_a.push_back(i);
        in_b.push_back(j);
        y.push_back(a[i] + b[j] + 0.5 * draws.normal());
      }
  EXPECT_NEAR(main_effect(in_a, y), 9 / 10.25, 0.01);
  EXPECT_NEAR(main_effect(in_b, y), 1 / 10.25, 0.01);
}

TEST(MainEffect, OfNoiseIsNearZeroHoweverSmallTheGroups) {
  double sum = 0;
  for (int t = 0; t < 200; ++t) {
    Draws draws(t);
    std::vector<int> group;
    std::vector<double> y;
    for (int i = 0; i < 24; ++i) {
      group.push_back(i / 2);
      y.push_back(draws.normal());
    }
    sum += main_effect(group, y);
  }
  // Without the correction it would be 11 / 23 = 0.48; what is clamped at zero leaves a tenth.
  EXPECT_LT(sum / 200, 0.2);
}

TEST(RobustScore, IsAnOrderStatistic) {
  EXPECT_EQ(robust_score({0.5, 0.3, 0.9}), 0.3);
  EXPECT_EQ(robust_score(ladder(101, 0, 1)), 0.05);
  EXPECT_EQ(robust_score({0.5, kNaN, 0.9}), 0.5);
  EXPECT_TRUE(std::isnan(robust_score({kNaN})));
}

TEST(Ranking, OrdersByWhatNinetyFivePercentReach) {
  // "steady" is worse in the middle, but better for the worst person.
  const auto ranked =
      rank_population({{"bold", ladder(30, 0.1, 1.0)}, {"steady", ladder(30, 0.5, 0.54)}}, 0.5);
  EXPECT_EQ(ranked[0].site, "steady");
  EXPECT_EQ(ranked[0].rank, 1);
  EXPECT_EQ(ranked[0].passing, 1);
  EXPECT_EQ(ranked[1].rank, 2);
  EXPECT_GT(ranked[1].median, ranked[0].median);
  EXPECT_GT(ranked[0].first, 0.95);
  EXPECT_NEAR(ranked[0].first + ranked[1].first, 1, 1e-12);
}

TEST(Ranking, TiesWhatTheDataCannotTellApart) {
  // The same values, but other people have them.
  const std::vector<double> a = ladder(40, 0.5, 0.7), c = ladder(40, 0.0, 0.2);
  const std::vector<double> b(a.rbegin(), a.rend());
  const auto ranked = rank_population({{"c", c}, {"a", a}, {"b", b}}, 0.5);
  EXPECT_EQ(ranked[2].site, "c");
  EXPECT_EQ(ranked[2].rank, 3);
  EXPECT_EQ(ranked[0].rank, 1);
  EXPECT_EQ(ranked[1].rank, 1);
  EXPECT_EQ(ranked[0].tied_with, std::vector<std::string>{ranked[1].site});
  EXPECT_EQ(ranked[2].rank_interval.low, 3);
}

TEST(Ranking, PutsUnratedSitesLast) {
  const auto ranked = rank_population({{"none", {kNaN, kNaN}}, {"some", {0.2, kNaN}}}, 0.5);
  EXPECT_EQ(ranked[0].site, "some");
  EXPECT_EQ(ranked[0].rated, 1);
  EXPECT_EQ(ranked[1].rank, 0);
}

// Where nobody is rated there is nothing to be the best in.
TEST(Ranking, HasNoWinnerAmongSitesThatNobodyRated) {
  for (const std::size_t people : {1u, 2u}) {
    const std::vector<double> nobody(people, kNaN);
    const auto ranked = rank_population({{"a", nobody}, {"b", nobody}}, 0.5);
    for (const SitePopulation& site : ranked) {
      EXPECT_EQ(site.rank, 0);
      EXPECT_TRUE(std::isnan(site.first)) << site.first;
      EXPECT_TRUE(std::isnan(site.rank_interval.low) && std::isnan(site.rank_interval.high));
      EXPECT_TRUE(std::isnan(site.passing));
    }
  }
  const auto ranked = rank_population({{"none", {kNaN, kNaN}}, {"both", {0.2, 0.3}}}, 0.5);
  EXPECT_EQ(ranked[0].first, 1);
  EXPECT_TRUE(std::isnan(ranked[1].first));
  EXPECT_TRUE(std::isnan(rank_population({{"alone", {0.9}}}, 0.5)[0].first)) << "without draws";
}

TEST(Sensors, AreChosenForWhatTheyAdd) {
  // The best alone serves people 1 to 3, the second best the same; the third serves person 4.
  const std::vector<SiteScores> sites = {
      {"best", {1, 1, 0.8, 0}}, {"twin", {1, 1, 0.7, 0}}, {"other", {0, 0, 0, 0.9}}};
  const auto chosen = choose_sensors(sites, 3);
  ASSERT_EQ(chosen.size(), 2u);  // the twin adds nothing
  EXPECT_EQ(chosen[0].site, "best");
  EXPECT_NEAR(chosen[0].mean, 2.8 / 4, 1e-15);
  EXPECT_EQ(chosen[1].site, "other");
  EXPECT_NEAR(chosen[1].mean, 3.7 / 4, 1e-15);
  EXPECT_NEAR(chosen[1].robust, 0.8, 1e-15);
}

TEST(Sensors, LeaveOutWhoIsRatedNowhere) {
  const std::vector<SiteScores> sites = {{"a", {0.8, kNotKnown, kNotKnown}},
                                         {"b", {0.2, 0.6, kNotKnown}}};
  const auto chosen = choose_sensors(sites, 2);
  ASSERT_EQ(chosen.size(), 2u);
  EXPECT_EQ(chosen[0].site, "a");
  EXPECT_NEAR(chosen[0].mean, 0.8 / 2, 1e-15) << "the second is not rated there";
  EXPECT_NEAR(chosen[1].mean, 1.4 / 2, 1e-15);
  EXPECT_NEAR(chosen[1].robust, 0.6, 1e-15);
  EXPECT_TRUE(choose_sensors({{"a", {kNotKnown}}}, 1).empty());
}

TEST(Sensors, GreedyIsWithinItsBoundOfTheBestPair) {
  for (int t = 0; t < 50; ++t) {
    Draws draws(t);
    std::vector<SiteScores> sites;
    for (int s = 0; s < 8; ++s) {
      sites.push_back({std::to_string(s), {}});
      for (int p = 0; p < 10; ++p) sites.back().scores.push_back(draws.uniform());
    }
    double best = 0;
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < i; ++j) {
        double mean = 0;
        for (int p = 0; p < 10; ++p) mean += std::max(sites[i].scores[p], sites[j].scores[p]) / 10;
        best = std::max(best, mean);
      }
    EXPECT_GE(choose_sensors(sites, 2).back().mean, 0.75 * best);  // 1 − (1 − 1/2)²
  }
}

TEST(Sensors, KeepTheirDistanceAndStayOffWhatIsExcluded) {
  const std::vector<SiteScores> sites = {{"a", {1, 0, 0}}, {"b", {0, 0.9, 0}}, {"c", {0, 0, 0.5}}};
  SensorConstraints constraints;
  constraints.apart = {{0, 1, 0}, {1, 0, 0}, {0, 0, 0}};
  auto chosen = choose_sensors(sites, 2, constraints);
  EXPECT_EQ(chosen[1].site, "c");
  constraints.excluded = {1, 0, 0};
  chosen = choose_sensors(sites, 2, constraints);
  EXPECT_EQ(chosen[0].site, "b");
}

TEST(HowLoose, InterpolatesBetweenTheLevels) {
  const std::vector<double> bgm = {0, 0.1, 0.2, 0.3};
  const auto expect = [&](const std::vector<double>& score, double low, double high) {
    const Bounds limit = limit_bounds(bgm, score, 0.5);
    EXPECT_DOUBLE_EQ(limit.low, low);
    EXPECT_DOUBLE_EQ(limit.high, high);
  };
  expect({1, 0.8, 0.4, 0}, 0.175, 0.175);
  expect({1, 0.8, 0.6, 0.5}, kInfinity, kInfinity);
  expect({0.4, 0.3, 0.2, 0}, -kInfinity, -kInfinity);
  // Of two stretches that pass the looser one counts.
  expect({1, 0, 0.6, 0.4}, 0.25, 0.25);
  // What is not rated neither passes nor fails: the limit is between the levels that are.
  expect({1, 0.8, kNaN, 0}, 0.1, 0.3);
  expect({1, 0.8, kNaN, kNaN}, 0.1, kInfinity);
  expect({1, kNaN, kNaN, 0.5}, kInfinity, kInfinity);
  expect({kNaN, 0.8, 0.4, 0}, 0.175, 0.175);
  expect({kNaN, kNaN, 0.2, 0.1}, -kInfinity, 0.2);
  expect({0.4, 0.3, 0.2, kNaN}, -kInfinity, -kInfinity);
  expect({kNaN, kNaN, kNaN, kNaN}, -kInfinity, kInfinity);
}

// Whoever is drawn alone is rated at the tighter fits, or nowhere.
TEST(HowLoose, KnowsNothingOfPeopleWhoAreNotRated) {
  const std::vector<double> bgm = {0, 0.1, 0.2, 0.3};
  std::vector<LooseLevel> levels;
  for (const double b : bgm) levels.push_back({b, {0.95 - 2 * b, 0.95 - 2 * b}});
  EXPECT_NEAR(how_loose(levels, 0.5).interval.high, 0.225, 1e-12);
  levels[2].scores[1] = levels[3].scores[1] = kNaN;
  const HowLoose beyond = how_loose(levels, 0.5);
  EXPECT_NEAR(beyond.limit, 0.225, 1e-12);
  EXPECT_EQ(beyond.at_most, beyond.limit);
  EXPECT_EQ(beyond.interval.low, 0.1);
  EXPECT_EQ(beyond.interval.high, kInfinity) << "in a quarter of the draws nothing is known beyond";
  for (LooseLevel& level : levels) level.scores[1] = kNaN;
  EXPECT_EQ(how_loose(levels, 0.5).interval.low, -kInfinity);
  EXPECT_EQ(how_loose(levels, 0.5).interval.high, kInfinity);
}

TEST(HowLoose, ComfortIsTheTightestFromWhichOnItHolds) {
  const std::vector<double> bgm = {0, 0.1, 0.2};
  EXPECT_NEAR(least_within(bgm, {0.05, 0.03, 0}, 0.01), 0.1 + 0.1 * 2 / 3, 1e-12);
  EXPECT_EQ(least_within(bgm, {0.01, 0, 0}, 0.01), -kInfinity);
  EXPECT_EQ(least_within(bgm, {1, 1, 1}, 0.01), kInfinity);
  EXPECT_EQ(least_within(bgm, {kInfinity, 0, 0}, 0.01), 0.1);
}

TEST(HowLoose, OfALinearPopulationIsItsLinearLimit) {
  // Person p scores t_p − 2 b with t from 0.9 to 1.1: the robust score passes 0.5 up to b = 0.2 for
  // the worst of few people, exactly.
  std::vector<LooseLevel> levels;
  for (const double bgm : {0.0, 0.1, 0.2, 0.3, 0.4}) {
    LooseLevel& level = levels.emplace_back();
    level.bgm = bgm;
    for (const double t : ladder(15, 0.9, 1.1)) level.scores.push_back(t - 2 * bgm);
  }
  const HowLoose answer = how_loose(levels, 0.5);
  EXPECT_NEAR(answer.limit, 0.2, 1e-9);
  EXPECT_NEAR(answer.interval.low, 0.2, 1e-9);  // nobody worse can be drawn
  EXPECT_GT(answer.interval.high, 0.2);
  EXPECT_LT(answer.interval.high, 0.25);
  EXPECT_EQ(answer.tightest, -kInfinity);
  EXPECT_EQ(answer.curve[2].passing, 1);
  EXPECT_NE(in_words(answer).find("up to a BGM of 0.20"), std::string::npos) << in_words(answer);
  EXPECT_EQ(answer.people, 15);
  EXPECT_NE(in_words(answer).find(" of 15 people only"), std::string::npos) << in_words(answer);
  for (LooseLevel& level : levels) level.scores.resize(7);
  EXPECT_EQ(in_words(how_loose(levels, 0.5)).find("interval"), std::string::npos);
}

TEST(HowLoose, TellsTheTightEndOfWhatPasses) {
  std::vector<LooseLevel> levels = {{0.0, {0.2, 0.3}}, {0.1, {0.8, 0.9}}, {0.2, {0.2, 0.3}}};
  const HowLoose answer = how_loose(levels, 0.5);
  EXPECT_NEAR(answer.limit, 0.15, 1e-12);
  EXPECT_NEAR(answer.tightest, 0.05, 1e-12);
  // It is not known to fail where nobody is rated.
  levels[0].scores = {kNaN, kNaN};
  EXPECT_EQ(how_loose(levels, 0.5).tightest, -kInfinity);
  levels.insert(levels.begin(), {-0.1, {0.2, 0.3}});
  EXPECT_NEAR(how_loose(levels, 0.5).tightest, 0.1, 1e-12);
}

}  // namespace
}  // namespace loosefit::study
