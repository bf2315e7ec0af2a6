#include "loosefit/study/limit_difference.h"

#include <gtest/gtest.h>

#include <limits>

// Against closed forms. Person p of these studies scores t_p − 2 b at the BGM b, so that the limit
// of few people is half of what the least t is above the pass mark.
namespace loosefit::study {
namespace {

constexpr double kPass = 0.5, kTolerance = 1e-9;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<LooseLevel> people(const std::vector<double>& t) {
  std::vector<LooseLevel> levels;
  for (const double bgm : {0.0, 0.1, 0.2, 0.3}) {
    LooseLevel& level = levels.emplace_back();
    level.bgm = bgm;
    for (const double own : t) level.scores.push_back(own - 2 * bgm);
  }
  return levels;
}

bool says(const LimitDifference& limits, const std::string& phrase) {
  return in_words(limits).find(phrase) != std::string::npos;
}

// Everybody gains 0.06: in every draw of the same people the limits differ by 0.03.
TEST(LimitDifference, OfTheSamePeopleHasNoSpreadWhereAllGainAlike) {
  const std::vector<LooseLevel> a = people({0.6, 0.7, 0.8, 0.9}),
                                b = people({0.76, 0.66, 0.96, 0.86});
  const LimitDifference limits = limit_difference(a, b, kPass, {1, 0, 3, 2});
  EXPECT_TRUE(limits.paired);
  EXPECT_NEAR(limits.limit_a, 0.05, kTolerance);
  EXPECT_NEAR(limits.limit_b, 0.08, kTolerance);
  EXPECT_NEAR(limits.difference, 0.03, kTolerance);
  EXPECT_NEAR(limits.interval.low, 0.03, kTolerance);
  EXPECT_NEAR(limits.interval.high, 0.03, kTolerance);
  EXPECT_TRUE(limits.differs());
  EXPECT_EQ(limits.open_draws, 0);
  EXPECT_EQ(limits.people_a, 4);
  EXPECT_TRUE(says(limits, "B - A = +0.030, 90 % interval +0.030 to +0.030")) << in_words(limits);
  // Of other pairs the draws tell something else.
  const LimitDifference wrong = limit_difference(a, b, kPass, {0, 1, 2, 3});
  EXPECT_GT(wrong.interval.high - wrong.interval.low, 0.04);
}

// The least of two that are drawn of two is the better one in a quarter of the draws. Drawn by
// themselves, A or B alone has it in 3/16: more than the 5 % that an interval leaves out.
TEST(LimitDifference, OfOtherPeopleIsDrawnInEachStudyByItself) {
  const std::vector<LooseLevel> a = people({0.6, 0.8}), b = people({0.66, 0.86});
  const LimitDifference limits = limit_difference(a, b, kPass, {});
  EXPECT_FALSE(limits.paired);
  EXPECT_NEAR(limits.difference, 0.03, kTolerance);
  EXPECT_NEAR(limits.interval.low, 0.08 - 0.15, kTolerance);
  EXPECT_NEAR(limits.interval.high, 0.18 - 0.05, kTolerance);
  EXPECT_FALSE(limits.differs());
  // With the people of A worse off by more than they spread, B is looser whoever is drawn.
  EXPECT_TRUE(limit_difference(people({0.55, 0.6}), b, kPass, {}).differs());
  // Studies may have different numbers of people.
  const LimitDifference uneven = limit_difference(a, people({0.66, 0.66, 0.66}), kPass, {});
  EXPECT_NEAR(uneven.interval.low, 0.08 - 0.15, kTolerance);
  EXPECT_NEAR(uneven.interval.high, 0.03, kTolerance);
  EXPECT_EQ(uneven.people_b, 3);
}

TEST(LimitDifference, OfALimitThatIsNoNumberIsNone) {
  const std::vector<LooseLevel> some = people({0.6, 0.8}), all = people({1.2, 1.3}),
                                none = people({0.3, 0.4});
  const auto expect_none = [](const LimitDifference& limits, const std::string& words) {
    EXPECT_TRUE(std::isnan(limits.difference));
    EXPECT_TRUE(std::isnan(limits.interval.low) && std::isnan(limits.interval.high));
    EXPECT_FALSE(limits.differs());
    EXPECT_EQ(in_words(limits), words);
  };
  expect_none(limit_difference(all, some, kPass, {0, 1}),
              "no number: A still passes at 0.30, the loosest tried; B passes up to 0.05");
  expect_none(limit_difference(some, none, kPass, {0, 1}),
              "no number: A passes up to 0.05; B passes at none of the fits tried, 0.00 to 0.30");
  expect_none(limit_difference(all, all, kPass, {0, 1}),
              "no number: A still passes at 0.30, the loosest tried; B still passes at 0.30, the "
              "loosest tried");
  EXPECT_EQ(limit_difference(none, all, kPass, {0, 1}).limit_a, -kInfinity);
  EXPECT_EQ(limit_difference(none, all, kPass, {0, 1}).limit_b, kInfinity);
}

// In a quarter of the draws of A only the person is there who passes at every fit. What B is less
// than that is at most 0.1 − 0.3, and may be anything below.
TEST(LimitDifference, IsOpenWhereDrawsLeaveTheFitsTried) {
  const std::vector<LooseLevel> a = people({0.6, 1.5}), b = people({0.7, 0.7});
  const LimitDifference limits = limit_difference(a, b, kPass, {0, 1});
  EXPECT_NEAR(limits.difference, 0.05, kTolerance);
  EXPECT_EQ(limits.interval.low, -kInfinity);
  EXPECT_NEAR(limits.interval.high, 0.05, kTolerance);
  EXPECT_NEAR(limits.open_draws, 0.25, 0.03);
  EXPECT_FALSE(limits.differs());
  EXPECT_EQ(limit_interval_text(limits.interval), "open to +0.050");
  EXPECT_TRUE(says(limits, "% of the draws a limit is outside the fits tried"));
  const LimitDifference turned = limit_difference(b, a, kPass, {0, 1});
  EXPECT_NEAR(turned.interval.low, -0.05, kTolerance);
  EXPECT_EQ(turned.interval.high, kInfinity);
  // Both outside in the same draws: nothing is known of these, and they are not left out.
  const LimitDifference both = limit_difference(a, people({0.7, 1.5}), kPass, {0, 1});
  EXPECT_NEAR(both.difference, 0.05, kTolerance);
  EXPECT_EQ(both.interval.low, -kInfinity);
  EXPECT_EQ(both.interval.high, kInfinity);
}

// A draw in which nobody passes anywhere has its limit, if any, below the tightest fit.
TEST(LimitDifference, OfDrawsThatPassNowhereIsBoundedByTheTightestFit) {
  std::vector<LooseLevel> a = people({0.9, 0.7}), b = people({0.8, 0.8});
  // The second person of A is not rated but at the tightest fits, where the first one fails: the
  // 5th percentile passes at 0.2 alone, by the first.
  for (LooseLevel& level : a) {
    if (level.bgm < 0.15) level.scores[0] = 0;
    if (level.bgm > 0.15) level.scores[1] = std::nan("");
  }
  a[0].scores[1] = a[1].scores[1] = 0;
  const LimitDifference limits = limit_difference(a, b, kPass, {0, 1});
  EXPECT_NEAR(limits.limit_a, 0.2, kTolerance);
  EXPECT_NEAR(limits.limit_b, 0.15, kTolerance);
  EXPECT_NEAR(limits.open_draws, 0.25, 0.03) << "draws of the second person alone";
  EXPECT_NEAR(limits.interval.low, -0.05, kTolerance);
  EXPECT_EQ(limits.interval.high, kInfinity);
}

TEST(LimitDifference, OfOnePersonHasNoInterval) {
  const LimitDifference limits = limit_difference(people({0.6}), people({0.7}), kPass, {0});
  EXPECT_NEAR(limits.difference, 0.05, kTolerance);
  EXPECT_TRUE(std::isnan(limits.interval.low));
  EXPECT_EQ(in_words(limits), "B - A = +0.050, no interval");
}

}  // namespace
}  // namespace loosefit::study
