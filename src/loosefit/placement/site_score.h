#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/placement/scorecard.h"

namespace loosefit::placement {

/// Share of the samples (donnings, later bodies) that may fall below the robust score.
inline constexpr double kRobustShare = 0.05;

/// What many samples say of one site. Unrated as soon as one sample cannot be rated.
struct SiteScore {
  std::vector<double> samples;  ///< score per sample; empty when not rated
  double median = 0;
  double robust = 0;   ///< quantile kRobustShare: with 20 samples or fewer the worst of them
  double margin = 0;   ///< of the robust sample, not clamped; tells equal scores apart
  double passing = 0;  ///< share of samples with a score of at least Scorecard::pass
  double bound = 0;    ///< not rated: the score is at most this
  int robust_sample = -1;
  std::string metric;                ///< limiting criterion of the robust sample
  std::string reason;                ///< in words; or "not rated: needs …"
  std::vector<std::string> missing;  ///< metrics that a sample lacks
  bool rated() const { return !samples.empty(); }
};

/// \throws InvalidInput without samples or criteria.
SiteScore score_samples(const std::vector<MetricValues>& samples, const Scorecard& scorecard);

}  // namespace loosefit::placement
