#include "loosefit/placement/rank.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/placement/resample.h"

namespace loosefit::placement {
namespace {

/// Scores by hand: contact_ratio is the score.
Scorecard plain() {
  Scorecard card;
  card.criteria = {{"contact_ratio", {1, 0}, {}, "lifts off", "", "test"}};
  return card;
}

SiteSamples site(const std::string& name, const std::vector<double>& scores) {
  SiteSamples s{name, {}};
  for (double q : scores) s.samples.push_back({{"contact_ratio", q}});
  return s;
}

Ranking rank(const std::vector<SiteSamples>& sites, const RankOptions& options = {}) {
  return rank_sites(sites, plain(), options);
}

std::vector<std::string> order(const Ranking& ranking) {
  std::vector<std::string> names;
  for (const RankedSite& s : ranking.sites) names.push_back(s.name);
  return names;
}

TEST(SiteScore, SummarisesSamples) {
  const SiteScore s = score_samples(site("a", {0.9, 0.4, 0.6, 0.5}).samples, plain());
  EXPECT_DOUBLE_EQ(s.robust, 0.4);
  EXPECT_EQ(s.robust_sample, 1);
  EXPECT_DOUBLE_EQ(s.median, 0.55);
  EXPECT_DOUBLE_EQ(s.passing, 0.75) << "from 0.5 on";
  EXPECT_EQ(s.metric, "contact_ratio");
  EXPECT_EQ(s.reason, "lifts off: 0.4, good from 1, fails at 0");
  EXPECT_THROW(score_samples({}, plain()), InvalidInput);
  EXPECT_THROW(score_samples({{}}, Scorecard{}), InvalidInput);
}

TEST(SiteScore, OneSampleWithoutAMetricIsNotRated) {
  SiteSamples s = site("a", {0.9, 0.4});
  s.samples[1].clear();
  const SiteScore score = score_samples(s.samples, plain());
  EXPECT_FALSE(score.rated());
  EXPECT_DOUBLE_EQ(score.bound, 0.9);
  EXPECT_EQ(score.missing, std::vector<std::string>{"contact_ratio"});
}

TEST(Rank, RobustScoreComesBeforeTheMedian) {
  const Ranking r = rank({site("brilliant but fickle", {1.0, 1.0, 0.1}),
                          site("steady", {0.5, 0.5, 0.5}), site("poor", {0.2, 0.3, 0.1})});
  EXPECT_EQ(order(r), (std::vector<std::string>{"steady", "brilliant but fickle", "poor"}));
  EXPECT_EQ(r.sites[0].index, 1);
  EXPECT_EQ(r.samples, 3);
}

TEST(Rank, SitesThatNeverMeetAreNotTied) {
  const Ranking r = rank({site("low", {0.1, 0.2, 0.3}), site("high", {0.6, 0.7, 0.5})});
  ASSERT_EQ(order(r), (std::vector<std::string>{"high", "low"}));
  EXPECT_EQ(r.sites[0].rank, 1);
  EXPECT_EQ(r.sites[1].rank, 2);
  EXPECT_TRUE(r.sites[0].tied_with.empty());
  EXPECT_EQ(r.sites[0].rank_interval->low, 1);
  EXPECT_EQ(r.sites[0].rank_interval->high, 1);
  EXPECT_EQ(r.sites[1].rank_interval->low, 2);
}

// Draws of (a better, b better): both first 1/4, both second 1/4, mixed 1/2 with equal worst and
// equal median, which count half. Either order has 1/2.
TEST(Rank, MirrorImagesAreTied) {
  const Ranking r = rank({site("a", {1, 0.2}), site("b", {0.2, 1})});
  EXPECT_EQ(r.sites[0].rank, 1);
  EXPECT_EQ(r.sites[1].rank, 1);
  EXPECT_EQ(r.sites[0].tied_with, std::vector<std::string>{"b"});
  EXPECT_EQ(r.sites[0].rank_interval->low, 1);
  EXPECT_EQ(r.sites[0].rank_interval->high, 2);
}

// a beats b unless its bad samples are drawn: chance (good share)^n that they are not.
TEST(Rank, TieFollowsTheChanceOfDrawingABadSample) {
  const SiteSamples b3 = site("b", {0.3, 0.3, 0.3}), b2 = site("b", {0.3, 0.3});
  const Ranking tied = rank({site("a", {0.9, 0.1}), b2});  // (1/2)^2 = 0.25 > 0.20
  EXPECT_EQ(tied.sites[1].rank, 1);
  EXPECT_EQ(order(tied), (std::vector<std::string>{"b", "a"}));
  const Ranking apart = rank({site("a", {0.9, 0.1, 0.1}), b3});  // (1/3)^3 = 0.037
  EXPECT_EQ(apart.sites[1].rank, 2);
  RankOptions strict;
  strict.tie_share = 0.02;
  EXPECT_EQ(rank({site("a", {0.9, 0.1, 0.1}), b3}, strict).sites[1].rank, 1);
}

// The median of two samples is bad in 1/4, middling in 1/2, good in 1/4 of the draws.
TEST(Rank, IntervalsArePercentilesOfTheDraws) {
  RankOptions half;
  half.confidence = 0.4;  // from the 30 % to the 70 % point: only middling medians
  const RankedSite s = rank({site("a", {0.2, 0.8})}, half).sites[0];
  EXPECT_DOUBLE_EQ(s.median_interval->low, 0.5);
  EXPECT_DOUBLE_EQ(s.median_interval->high, 0.5);
  const RankedSite wide = rank({site("a", {0.2, 0.8})}).sites[0];
  EXPECT_DOUBLE_EQ(wide.median_interval->low, 0.2);
  EXPECT_DOUBLE_EQ(wide.median_interval->high, 0.8);
  EXPECT_DOUBLE_EQ(wide.robust_interval->low, 0.2);
  EXPECT_DOUBLE_EQ(wide.robust_interval->high, 0.8) << "all of both: 1/4";
}

// Two donnings of one wearer tell less than those of two: four each that are the same tell nothing.
TEST(Rank, IntervalsAreOfWearersEachWithAllItsDonnings) {
  const std::vector<double> of_wearers = {0.1, 0.3, 0.5, 0.7, 0.9};
  std::vector<double> of_donnings;
  RankOptions together;
  for (int w = 0; w < 5; ++w)
    for (int d = 0; d < 4; ++d)
      of_donnings.push_back(of_wearers[w]), together.wearer_of_sample.push_back(w);
  const Ranking few = rank({site("a", of_wearers)}),
                many = rank({site("a", of_donnings)}, together),
                alone = rank({site("a", of_donnings)});
  EXPECT_EQ(many.samples, 20);
  EXPECT_EQ(many.draws_of, 5);
  EXPECT_EQ(few.sites[0].median_interval->low, many.sites[0].median_interval->low);
  EXPECT_EQ(few.sites[0].median_interval->high, many.sites[0].median_interval->high);
  EXPECT_LT(alone.sites[0].median_interval->high - alone.sites[0].median_interval->low,
            many.sites[0].median_interval->high - many.sites[0].median_interval->low);
  ASSERT_EQ(many.notes.size(), 2u);
  EXPECT_EQ(many.notes[0],
            "20 samples of only 5 wearers, of whom the intervals are: they are rough");
  // Donnings of one wearer are all there is.
  RankOptions one;
  one.wearer_of_sample.assign(20, 0);
  const Ranking single = rank({site("a", of_donnings)}, one);
  EXPECT_EQ(single.draws_of, 20);
  EXPECT_EQ(single.sites[0].median_interval->low, alone.sites[0].median_interval->low);
  one.wearer_of_sample.pop_back();
  EXPECT_THROW(rank({site("a", of_donnings)}, one), InvalidInput);
}

TEST(Rank, TiesShareTheRankOfTheirBest) {
  const Ranking r = rank(
      {site("d", {0.1, 0.1}), site("a", {0.9, 0.9}), site("b", {0.5, 0.5}), site("c", {0.5, 0.5})});
  EXPECT_EQ(order(r), (std::vector<std::string>{"a", "b", "c", "d"}));
  EXPECT_EQ(r.sites[1].rank, 2);
  EXPECT_EQ(r.sites[2].rank, 2);
  EXPECT_EQ(r.sites[3].rank, 4);
}

TEST(Rank, OneSampleHasNoIntervalAndSaysSo) {
  const Ranking r = rank({site("a", {0.3}), site("b", {0.7}), site("c", {0.7})});
  EXPECT_EQ(order(r), (std::vector<std::string>{"b", "c", "a"}));
  EXPECT_FALSE(r.sites[0].robust_interval || r.sites[0].rank_interval);
  EXPECT_EQ(r.sites[1].rank, 1) << "exactly equal";
  EXPECT_EQ(r.sites[2].rank, 3);
  ASSERT_EQ(r.notes.size(), 1u);
  EXPECT_NE(r.notes[0].find("one sample"), std::string::npos);
}

TEST(Rank, SaysWhenTheRobustScoreIsTheWorst) {
  EXPECT_EQ(rank({site("a", {0.3, 0.4})}).notes.size(), 2u);
  const Ranking many = rank({site("a", std::vector<double>(20, 0.5))});
  ASSERT_EQ(many.notes.size(), 1u);
  EXPECT_EQ(many.notes[0], "the robust score is the worst of 20 samples");
  EXPECT_TRUE(rank({site("a", std::vector<double>(21, 0.5))}).notes.empty());
}

TEST(Rank, UnratedSitesComeLastWithoutARank) {
  SiteSamples unknown{"unknown", {{}}};
  const Ranking r = rank({unknown, site("a", {0.0})});
  EXPECT_EQ(order(r), (std::vector<std::string>{"a", "unknown"}));
  EXPECT_EQ(r.sites[0].rank, 1);
  EXPECT_EQ(r.sites[1].rank, 0);
  EXPECT_EQ(r.sites[1].score.reason, "not rated: needs contact_ratio");
  EXPECT_TRUE(rank({}).sites.empty());
  EXPECT_EQ(rank({{"unknown", {{}, {}}}}).sites[0].rank, 0);
}

TEST(Rank, SameSeedSameResultOtherSeedSameTies) {
  const std::vector<SiteSamples> sites = {site("a", {0.9, 0.1, 0.5}), site("b", {0.3, 0.4, 0.45})};
  RankOptions other;
  other.seed = 99;
  const Ranking r = rank(sites), again = rank(sites), elsewhere = rank(sites, other);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(r.sites[i].median_interval->low, again.sites[i].median_interval->low);
    EXPECT_EQ(r.sites[i].rank, elsewhere.sites[i].rank);
  }
}

TEST(Rank, RefusesUnequalSamplesAndBadOptions) {
  const auto message = [](const std::vector<SiteSamples>& sites, const RankOptions& options) {
    try {
      rank(sites, options);
    } catch (const InvalidInput& e) {
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  EXPECT_NE(
      message({site("a", {1, 1}), site("b", {1})}, {}).find("site b: found 1 samples, expected 2"),
      std::string::npos);
  EXPECT_NE(message({site("a", {})}, {}).find("found 0 samples, expected 1"), std::string::npos);
  RankOptions bad;
  bad.tie_share = 0.5;
  EXPECT_NE(message({site("a", {1})}, bad).find("tie_share"), std::string::npos);
  bad = {};
  bad.confidence = 1;
  EXPECT_NE(message({site("a", {1})}, bad).find("confidence"), std::string::npos);
  bad = {};
  bad.resamples = 0;
  EXPECT_NE(message({site("a", {1})}, bad).find("resamples"), std::string::npos);
}

TEST(Resample, DrawsAreUniformAndFixedBySeed) {
  const auto draws = bootstrap_draws(4, 20000, 7);
  std::vector<int> count(4, 0);
  for (const auto& draw : draws)
    for (int k : draw) ++count.at(k);
  for (int c : count) EXPECT_NEAR(c, 20000, 5 * std::sqrt(20000 * 0.75));
  EXPECT_EQ(draws, bootstrap_draws(4, 20000, 7));
  EXPECT_NE(draws, bootstrap_draws(4, 20000, 8));
}

TEST(Resample, ShuffleIsAPermutation) {
  std::vector<int> seen(100, 0);
  const auto order = shuffled(100, 3);
  for (int k : order) ++seen.at(k);
  EXPECT_EQ(seen, std::vector<int>(100, 1));
  EXPECT_NE(order, shuffled(100, 4));
  EXPECT_TRUE(shuffled(0, 1).empty());
}

}  // namespace
}  // namespace loosefit::placement
