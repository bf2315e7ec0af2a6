#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/placement/site_score.h"

namespace loosefit::placement {

/// A site with its metrics: one map per sample. Sample k of every site is the same donning (or
/// body), so that resampling keeps the sites of one drape together.
struct SiteSamples {
  std::string name;
  std::vector<MetricValues> samples;
};

/// How certain ranks are judged.
struct RankOptions {
  std::uint64_t seed = 1;
  int resamples = 2000;      ///< bootstrap draws
  double confidence = 0.90;  ///< of the intervals
  double tie_share = 0.20;   ///< tied when either order comes up in more than this share of draws
  /// Per sample whose it is: samples of one wearer are drawn together. Empty: each of its own.
  std::vector<int> wearer_of_sample = {};
};

struct Interval {
  double low = 0, high = 0;
};

/// One site in its place of a ranking.
struct RankedSite {
  int index = 0;  ///< in the list that was ranked
  std::string name;
  /// 1 is best; sites that are tied with the best of a rank share it. 0: not rated.
  int rank = 0;
  SiteScore score;
  std::optional<Interval> median_interval, robust_interval, rank_interval;
  std::vector<std::string> tied_with;  ///< names of all sites it is tied with, best first
};

struct Ranking {
  int samples = 0;   ///< per site
  int draws_of = 0;  ///< how many things intervals are drawn of: wearers, or samples of one
  /// Rated sites by robust score, then median, then margin, then the given order; then the
  /// unrated ones by their upper bound.
  std::vector<RankedSite> sites;
  /// Said to the reader: one sample only, few samples, robust score is the worst of them.
  std::vector<std::string> notes;
};

/// Ranks sites by their robust score. Intervals and ties come from a bootstrap over the samples
/// (Efron 1979, percentile intervals; docs/theory/sensor_metrics.md 12): `resamples` times n
/// samples are drawn with replacement, the same ones for all sites, and the sites are ordered anew
/// by robust score and median. Of several wearers these are drawn, each with all its donnings,
/// since two donnings of one wearer tell less than those of two. Two sites are tied when each comes
/// before the other in more than tie_share of the draws, draws in which they are equal counting
/// half to either. With one sample there is no interval and no tie but exact equality. Same input
/// and seed, same result. Note that with few samples the robust score is their worst, whose
/// bootstrap interval reaches upwards only. \throws InvalidInput when sites have no samples, or not
/// equally many, or options are out of range.
Ranking rank_sites(const std::vector<SiteSamples>& sites, const Scorecard& scorecard,
                   const RankOptions& options = {});

}  // namespace loosefit::placement
