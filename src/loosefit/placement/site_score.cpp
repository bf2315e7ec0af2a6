#include "loosefit/placement/site_score.h"

#include <algorithm>
#include <numeric>

#include "loosefit/base/error.h"
#include "loosefit/base/quantile.h"
#include "loosefit/base/text.h"

namespace loosefit::placement {

SiteScore score_samples(const std::vector<MetricValues>& samples, const Scorecard& scorecard) {
  if (samples.empty()) throw InvalidInput("a site to be scored has no sample");
  if (scorecard.criteria.empty())
    throw InvalidInput("scorecard " + printable(scorecard.name) + " has no criterion");
  // Score every sample; the worst bound holds for a site that cannot be rated.
  std::vector<Score> scores;
  SiteScore result;
  result.bound = 1;
  for (const MetricValues& metrics : samples) {
    scores.push_back(score(metrics, scorecard));
    result.bound = std::min(result.bound, scores.back().bound);
    if (!scores.back().q && result.missing.empty()) {
      result.missing = scores.back().missing;
      result.reason = scores.back().reason;
    }
  }
  if (!result.missing.empty()) return result;
  // By score, equal ones by margin: the same sample is found whatever the order of equal scores.
  std::vector<int> order(samples.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return scores[a].margin < scores[b].margin; });
  // What the site has over all samples: scores, share that passes, and the robust sample.
  int passing = 0;
  for (const Score& s : scores) {
    result.samples.push_back(*s.q);
    passing += *s.q >= scorecard.pass;
  }
  result.robust_sample = order[quantile_index(order.size(), kRobustShare)];
  const Score& robust = scores[result.robust_sample];
  result.robust = *robust.q;
  result.margin = robust.margin;
  result.bound = result.robust;
  result.reason = robust.reason;
  result.metric = scorecard.criteria[robust.limiting].metric;
  result.median = median(result.samples);
  result.passing = static_cast<double>(passing) / static_cast<double>(samples.size());
  return result;
}

}  // namespace loosefit::placement
