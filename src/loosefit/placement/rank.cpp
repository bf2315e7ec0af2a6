#include "loosefit/placement/rank.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "loosefit/base/error.h"
#include "loosefit/base/quantile.h"
#include "loosefit/base/text.h"
#include "loosefit/placement/resample.h"

namespace loosefit::placement {
namespace {

constexpr int kFewSamples = 8;

void check(const std::vector<SiteSamples>& sites, const RankOptions& options) {
  if (options.resamples < 1 || !(options.confidence > 0 && options.confidence < 1) ||
      !(options.tie_share >= 0 && options.tie_share < 0.5))
    throw InvalidInput(
        "rank: found resamples, confidence or tie_share out of range, expected at least 1, "
        "between 0 and 1, and from 0 to below 0.5");
  for (const SiteSamples& site : sites)
    if (site.samples.empty() || site.samples.size() != sites.front().samples.size())
      throw InvalidInput(
          fmt::format("site {}: found {} samples, expected {}", printable(site.name),
                      site.samples.size(), std::max<std::size_t>(1, sites.front().samples.size())),
          "every site needs its metrics of every donning");
  if (!options.wearer_of_sample.empty() && !sites.empty() &&
      options.wearer_of_sample.size() != sites.front().samples.size())
    throw InvalidInput(fmt::format("rank: found wearers of {} samples, expected of {}",
                                   options.wearer_of_sample.size(), sites.front().samples.size()));
}

/// Samples that are drawn together: those of a wearer, where there are several.
std::vector<std::vector<int>> drawn_together(int samples, const std::vector<int>& wearer_of) {
  std::map<int, std::vector<int>> of_wearer;
  for (int k = 0; k < samples; ++k) of_wearer[wearer_of.empty() ? k : wearer_of[k]].push_back(k);
  std::vector<std::vector<int>> groups;
  if (of_wearer.size() == 1) {
    for (int k = 0; k < samples; ++k) groups.push_back({k});
  } else {
    for (auto& [wearer, of] : of_wearer) groups.push_back(std::move(of));
  }
  return groups;
}

/// Robust score and median: what orders sites in one draw.
using Standing = std::pair<double, double>;

/// Draw by draw, the standing of every rated site.
class Bootstrap {
 public:
  /// \param groups of samples, each drawn as a whole
  Bootstrap(const std::vector<SiteScore>& scores, const std::vector<int>& rated,
            const std::vector<std::vector<int>>& groups, const RankOptions& options)
      : options_(options), size_(rated.size()), before_(size_ * size_, 0.0) {
    medians_.resize(size_);
    robusts_.resize(size_);
    ranks_.resize(size_);
    std::vector<Standing> standing(size_);
    std::vector<double> drawn;
    for (const auto& draw :
         bootstrap_draws(static_cast<int>(groups.size()), options.resamples, options.seed)) {
      for (std::size_t i = 0; i < size_; ++i) {
        const std::vector<double>& samples = scores[rated[i]].samples;
        drawn.clear();
        for (int group : draw)
          for (int k : groups[group]) drawn.push_back(samples[k]);
        standing[i] = {quantile(drawn, kRobustShare), median(drawn)};
      }
      count(standing);
    }
  }
  /// Share of draws in which i comes before j.
  double before(std::size_t i, std::size_t j) const {
    return before_[i * size_ + j] / options_.resamples;
  }
  bool tied(std::size_t i, std::size_t j) const {
    return before(i, j) > options_.tie_share && before(j, i) > options_.tie_share;
  }
  Interval median_interval(std::size_t i) const { return interval(medians_[i]); }
  Interval robust_interval(std::size_t i) const { return interval(robusts_[i]); }
  Interval rank_interval(std::size_t i) const { return interval(ranks_[i]); }

 private:
  void count(const std::vector<Standing>& standing) {
    for (std::size_t i = 0; i < size_; ++i) {
      int better = 0;
      for (std::size_t j = 0; j < size_; ++j) {
        better += standing[j] > standing[i];
        if (i != j)
          before_[i * size_ + j] += standing[i] > standing[j]    ? 1.0
                                    : standing[i] == standing[j] ? 0.5
                                                                 : 0.0;
      }
      robusts_[i].push_back(standing[i].first);
      medians_[i].push_back(standing[i].second);
      ranks_[i].push_back(1 + better);
    }
  }
  Interval interval(const std::vector<double>& values) const {
    const double tail = 0.5 * (1 - options_.confidence);
    return {quantile(values, tail), quantile(values, 1 - tail)};
  }

  RankOptions options_;
  std::size_t size_;
  std::vector<double> before_;
  std::vector<std::vector<double>> medians_, robusts_, ranks_;
};

/// Rated indices best first, and unrated ones by their bound.
std::pair<std::vector<int>, std::vector<int>> ordered(const std::vector<SiteScore>& scores) {
  std::vector<int> rated, unrated;
  for (std::size_t i = 0; i < scores.size(); ++i)
    (scores[i].rated() ? rated : unrated).push_back(static_cast<int>(i));
  const auto standing = [&](int i) {
    return std::tuple(scores[i].robust, scores[i].median, scores[i].margin);
  };
  std::stable_sort(rated.begin(), rated.end(),
                   [&](int a, int b) { return standing(a) > standing(b); });
  std::stable_sort(unrated.begin(), unrated.end(),
                   [&](int a, int b) { return scores[a].bound > scores[b].bound; });
  return {rated, unrated};
}

/// \param drawn things that are drawn: wearers, or samples of one wearer
std::vector<std::string> notes(int samples, int drawn) {
  if (samples == 1)
    return {"one sample: no interval; folds are not unique, so the order may be chance"};
  std::vector<std::string> said;
  if (drawn < kFewSamples)
    said.push_back(drawn == samples
                       ? fmt::format("only {} samples: intervals are rough", samples)
                       : fmt::format("{} samples of only {} wearers, of whom the intervals are: "
                                     "they are rough",
                                     samples, drawn));
  if (samples * kRobustShare <= 1)
    said.push_back(fmt::format("the robust score is the worst of {} samples", samples));
  else if (drawn != samples)
    said.push_back(
        fmt::format("the robust score is the 5th percentile of all {} donnings, not of "
                    "{} wearers: some of them may score lower in their worst one",
                    samples, drawn));
  return said;
}

}  // namespace

Ranking rank_sites(const std::vector<SiteSamples>& sites, const Scorecard& scorecard,
                   const RankOptions& options) {
  Ranking ranking;
  if (sites.empty()) return ranking;
  check(sites, options);
  std::vector<SiteScore> scores;
  for (const SiteSamples& site : sites) scores.push_back(score_samples(site.samples, scorecard));
  const auto [rated, unrated] = ordered(scores);
  ranking.samples = static_cast<int>(sites.front().samples.size());
  const auto groups = drawn_together(ranking.samples, options.wearer_of_sample);
  ranking.draws_of = static_cast<int>(groups.size());
  ranking.notes = notes(ranking.samples, ranking.draws_of);

  std::optional<Bootstrap> bootstrap;
  if (ranking.samples > 1 && !rated.empty()) bootstrap.emplace(scores, rated, groups, options);
  const auto tied = [&](std::size_t i, std::size_t j) {
    const SiteScore &a = scores[rated[i]], &b = scores[rated[j]];
    return bootstrap ? bootstrap->tied(i, j) : a.robust == b.robust && a.median == b.median;
  };
  std::size_t leader = 0;
  for (std::size_t i = 0; i < rated.size(); ++i) {
    if (i > 0 && !tied(leader, i)) leader = i;
    RankedSite site{
        rated[i], sites[rated[i]].name, static_cast<int>(leader) + 1, scores[rated[i]], {}, {}, {},
        {}};
    for (std::size_t j = 0; j < rated.size(); ++j)
      if (j != i && tied(i, j)) site.tied_with.push_back(sites[rated[j]].name);
    if (bootstrap) {
      site.median_interval = bootstrap->median_interval(i);
      site.robust_interval = bootstrap->robust_interval(i);
      site.rank_interval = bootstrap->rank_interval(i);
    }
    ranking.sites.push_back(std::move(site));
  }
  for (int i : unrated) ranking.sites.push_back({i, sites[i].name, 0, scores[i], {}, {}, {}, {}});
  return ranking;
}

}  // namespace loosefit::placement
