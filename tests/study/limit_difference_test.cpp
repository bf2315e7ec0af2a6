#include "loosefit/study/limit_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

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

/// So many people alike but for the worst.
std::vector<LooseLevel> crowd(int count, double t) {
  std::vector<double> all(count, t);
  all.front() = t - 0.01;
  return people(all);
}

std::vector<int> in_order(int count) {
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

bool says(const LimitDifference& limits, const std::string& phrase) {
  return in_words(limits).find(phrase) != std::string::npos;
}

// Everybody gains 0.06: in every draw of the same people the limits differ by 0.03.
TEST(LimitDifference, OfTheSamePeopleHasNoSpreadWhereAllGainAlike) {
  const std::vector<LooseLevel> a = people({0.6, 0.7, 0.8, 0.9}),
                                b = people({0.76, 0.66, 0.96, 0.86});
  const LimitDifference limits = limit_difference(a, b, kPass, {1, 0, 3, 2});
  EXPECT_EQ(limits.drawn, PeopleDrawn::jointly);
  EXPECT_NEAR(limits.limit_a.low, 0.05, kTolerance);
  EXPECT_NEAR(limits.limit_b.low, 0.08, kTolerance);
  EXPECT_NEAR(limits.difference, 0.03, kTolerance);
  EXPECT_NEAR(limits.interval.low, 0.03, kTolerance);
  EXPECT_NEAR(limits.interval.high, 0.03, kTolerance);
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
  EXPECT_EQ(limits.drawn, PeopleDrawn::independently);
  EXPECT_NEAR(limits.difference, 0.03, kTolerance);
  EXPECT_NEAR(limits.interval.low, 0.08 - 0.15, kTolerance);
  EXPECT_NEAR(limits.interval.high, 0.18 - 0.05, kTolerance);
  // With the people of A worse off by more than they spread, B is looser whoever is drawn.
  EXPECT_GT(limit_difference(people({0.55, 0.6}), b, kPass, {}).interval.low, 0);
  // Studies may have different numbers of people.
  const LimitDifference uneven = limit_difference(a, people({0.66, 0.66, 0.66}), kPass, {});
  EXPECT_NEAR(uneven.interval.low, 0.08 - 0.15, kTolerance);
  EXPECT_NEAR(uneven.interval.high, 0.03, kTolerance);
  EXPECT_EQ(uneven.people_b, 3);
}

// The interval of the worst of few people says nothing of whether limits differ: zero is far out of
// all of these.
TEST(LimitDifference, IsToldToDifferWithMoreThanTwentyPeopleAlone) {
  const auto of = [](int people_a, int people_b) {
    return limit_difference(crowd(people_a, 0.6), crowd(people_b, 0.8), kPass,
                            people_a == people_b ? in_order(people_a) : std::vector<int>());
  };
  for (const auto& [a, b] : {std::pair{2, 2}, {12, 12}, {20, 20}, {20, 40}, {40, 20}}) {
    EXPECT_GT(of(a, b).interval.low, 0.08);
    EXPECT_FALSE(of(a, b).differs()) << a << ", " << b;
  }
  for (const auto& [a, b] : {std::pair{21, 21}, {21, 40}})
    EXPECT_TRUE(of(a, b).differs()) << a << ", " << b;
  EXPECT_FALSE(limit_difference(crowd(40, 0.6), crowd(40, 0.6), kPass, {}).differs());
  EXPECT_TRUE(limit_difference(crowd(40, 0.8), crowd(40, 0.6), kPass, {}).differs());
  // Of 40 people 20 are rated.
  std::vector<LooseLevel> half = crowd(40, 0.6);
  for (LooseLevel& level : half)
    std::fill(level.scores.begin() + 20, level.scores.end(), std::nan(""));
  EXPECT_FALSE(limit_difference(half, crowd(40, 0.8), kPass, in_order(40)).differs());
}

// B still passes at 0.3: it is at least 0.3 less the limit of A looser.
TEST(LimitDifference, OfALimitThatIsNoNumberIsBounded) {
  const std::vector<LooseLevel> some = people({0.7, 0.7}), all = people({1.2, 1.3}),
                                none = people({0.3, 0.4});
  const auto of = [](const std::vector<LooseLevel>& a, const std::vector<LooseLevel>& b) {
    const LimitDifference limits = limit_difference(a, b, kPass, {0, 1});
    EXPECT_TRUE(std::isnan(limits.difference)) << in_words(limits);
    EXPECT_EQ(limits.open_draws, 1);
    return limits;
  };
  const LimitDifference more = of(some, all);
  EXPECT_NEAR(more.interval.low, 0.2, kTolerance);
  EXPECT_EQ(more.interval.high, kInfinity);
  EXPECT_EQ(difference_text(more), "at least +0.200");
  EXPECT_EQ(in_words(more),
            "B - A is at least +0.200: A passes up to 0.100; B still passes at 0.300, the loosest "
            "tried, 90 % interval +0.200 to open; in 100.0 % of the draws a limit is no number");
  const LimitDifference less = of(all, some);
  EXPECT_EQ(less.interval.low, -kInfinity);
  EXPECT_NEAR(less.interval.high, -0.2, kTolerance);
  EXPECT_EQ(difference_text(less), "at most -0.200");
  EXPECT_EQ(difference_text(of(some, none)), "at most -0.100");
  EXPECT_TRUE(says(of(some, none), "B passes at none of the fits tried, 0.000 to 0.300"));
  EXPECT_EQ(difference_text(of(none, all)), "at least +0.300");
  EXPECT_EQ(of(none, all).limit_a.high, -kInfinity);
  EXPECT_EQ(of(none, all).limit_b.low, kInfinity);
  // Nothing is known where both pass everywhere, or nowhere.
  for (const std::vector<LooseLevel>& alike : {all, none}) {
    EXPECT_EQ(difference_text(of(alike, alike)), "-");
    EXPECT_TRUE(says(of(alike, alike), "no number: A ")) << in_words(of(alike, alike));
    EXPECT_FALSE(says(of(alike, alike), "nan")) << in_words(of(alike, alike));
  }
  EXPECT_TRUE(limit_difference(crowd(24, 0.7), crowd(24, 1.3), kPass, in_order(24)).differs());
  EXPECT_FALSE(limit_difference(crowd(24, 1.3), crowd(24, 1.3), kPass, in_order(24)).differs());
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
  EXPECT_TRUE(says(limits, "% of the draws a limit is no number"));
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
  std::vector<LooseLevel> a = people({0.9, 0.7});
  // The 5th percentile passes at 0.2 alone, where the second person of A is not rated.
  for (LooseLevel& level : a) {
    if (level.bgm < 0.15) level.scores = {0, 0};
    if (level.bgm > 0.15) level.scores[1] = level.bgm > 0.25 ? 0 : std::nan("");
  }
  const LimitDifference limits = limit_difference(a, people({0.8, 0.8}), kPass, {0, 1});
  EXPECT_NEAR(limits.limit_a.low, 0.2, kTolerance);
  EXPECT_NEAR(limits.limit_a.high, 0.2, kTolerance);
  EXPECT_NEAR(limits.open_draws, 0.25, 0.03) << "draws of the second person alone";
  EXPECT_NEAR(limits.interval.low, -0.05, kTolerance);
  EXPECT_EQ(limits.interval.high, kInfinity);
}

// Person 2 is not rated at the loosest fits: a quarter of the draws know only that the limit is at
// least 0.1, the last fit at which this person passes.
TEST(LimitDifference, OfDrawsThatAreNotRatedBeyondIsOpen) {
  std::vector<LooseLevel> a = people({0.95, 0.95});
  a[2].scores[1] = a[3].scores[1] = std::nan("");
  const LimitDifference limits = limit_difference(a, people({0.8, 0.8}), kPass, {0, 1});
  EXPECT_NEAR(limits.difference, 0.15 - 0.225, kTolerance);
  EXPECT_NEAR(limits.open_draws, 0.25, 0.03);
  EXPECT_EQ(limits.interval.low, -kInfinity);
  EXPECT_NEAR(limits.interval.high, 0.15 - 0.1, kTolerance);
  EXPECT_EQ(limit_difference(a, a, kPass, {0, 1}).difference, 0);
}

// Whom no fit rates tells nothing of the limit, not that it is nowhere.
TEST(LimitDifference, OfDrawsInWhichNobodyIsRatedIsNotKnown) {
  std::vector<LooseLevel> a = people({0.6, 0.6});
  for (LooseLevel& level : a) level.scores[1] = std::nan("");
  const std::vector<LooseLevel> b = people({0.8, 0.8});
  EXPECT_EQ(limit_difference(a, b, kPass, {0, 1}).drawn, PeopleDrawn::none) << "one is rated";
  for (LooseLevel& level : a) level.scores.push_back(level.scores[0]);
  const LimitDifference limits =
      limit_difference(a, people({0.8, 0.8, 0.8}), kPass, {0, 1, 2}, {1, 4000, 0.98});
  EXPECT_NEAR(limits.open_draws, 1 / 27., 0.015);
  EXPECT_EQ(limits.interval.low, -kInfinity);
  EXPECT_EQ(limits.interval.high, kInfinity);
}

// What all people say ends at a fit at which nobody is rated.
TEST(LimitDifference, OfALimitThatEndsAtAnUnratedFitIsBounded) {
  const auto without = [](std::initializer_list<int> levels) {
    std::vector<LooseLevel> some = people({0.72, 0.75});
    for (const int level : levels) some[level].scores.assign(2, std::nan(""));
    return some;
  };
  const std::vector<LooseLevel> b = people({0.9, 0.9});
  const auto of = [&](std::initializer_list<int> levels) {
    return limit_difference(without(levels), b, kPass, {0, 1});
  };
  EXPECT_EQ(limit_text(of({2, 3}).limit_a, {0, 0.3}), "at least 0.100");
  EXPECT_EQ(difference_text(of({2, 3})), "at most +0.100");
  EXPECT_TRUE(says(of({2, 3}), "A passes at least up to 0.100, beyond which nobody is rated"));
  EXPECT_EQ(limit_text(of({2}).limit_a, {0, 0.3}), "0.100 to 0.300");
  EXPECT_EQ(difference_text(of({2})), "-0.100 to +0.100");
  EXPECT_TRUE(says(of({2}), "A passes at least up to 0.100 and fails at 0.300"));
  EXPECT_EQ(limit_text(of({0, 1}).limit_a, {0, 0.3}), "at most 0.200");
  EXPECT_TRUE(says(of({0, 1}), "A fails from 0.200 on, short of which nobody is rated"));
  EXPECT_EQ(limit_text(of({0, 1, 2, 3}).limit_a, {0, 0.3}), "not known");
  for (const auto& levels : {std::initializer_list<int>{2, 3}, {2}, {0, 1}, {0, 1, 2, 3}})
    EXPECT_TRUE(std::isnan(of(levels).difference));
  EXPECT_NEAR(of({0}).difference, 0.2 - 0.11, kTolerance)
      << "a fit that tells nothing of the limit";
}

// A wearer at three fits: draws of these would say which fits there are.
TEST(LimitDifference, OfOneWearerHasNoInterval) {
  const auto wearer = [](double t) {
    std::vector<LooseLevel> levels = people({t, t, t, t});
    for (std::size_t k = 0; k < levels.size(); ++k)
      for (std::size_t i = 0; i < levels.size(); ++i)
        if (i != k) levels[k].scores[i] = std::nan("");
    return levels;
  };
  const LimitDifference limits = limit_difference_of_wearer(wearer(0.7), wearer(0.8), kPass);
  EXPECT_NEAR(limits.difference, 0.05, kTolerance);
  EXPECT_EQ(limits.people_a, 1);
  EXPECT_EQ(limits.people_b, 1);
  EXPECT_EQ(limits.drawn, PeopleDrawn::none);
  EXPECT_EQ(in_words(limits), "B - A = +0.050, no interval");
}

TEST(LimitDifference, OfOnePersonHasNoInterval) {
  const LimitDifference limits = limit_difference(people({0.6}), people({0.7}), kPass, {0});
  EXPECT_NEAR(limits.difference, 0.05, kTolerance);
  EXPECT_TRUE(std::isnan(limits.interval.low));
  EXPECT_EQ(in_words(limits), "B - A = +0.050, no interval");
}

}  // namespace
}  // namespace loosefit::study
