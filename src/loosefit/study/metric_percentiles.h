#pragma once
#include <string>
#include <vector>

#include "loosefit/placement/scorecard.h"
#include "loosefit/study/bootstrap.h"
#include "loosefit/study/study_data.h"

// What the sensors of a study meet: the degrees, millimetres and kilopascals behind its scores.
namespace loosefit::study {

/// One metric of a scorecard at one site over the people of a study, in the unit of the metric
/// (placement/metric_names.h). People are the cases at the level in a study without people.
struct MetricPercentiles {
  std::string site, metric;
  int known = 0, people = 0;       ///< people with a value, and all
  int known_cases = 0, cases = 0;  ///< of all people: cases with a value, and all
  double median = kNotKnown, p5 = kNotKnown, p95 = kNotKnown;  ///< NaN: nobody has a value
  Bounds median_interval = {kNotKnown, kNotKnown};
  Bounds p5_interval = {kNotKnown, kNotKnown}, p95_interval = {kNotKnown, kNotKnown};
};

/// A metric per unit at a level (−1: over all levels): of the cases of that unit the value that the
/// scorecard's criteria of this metric like least, of values alike the first. NaN where no case has
/// a value. \param by_case per case; NaN: none
std::vector<double> unit_metrics(const StudyData& data, const std::vector<double>& by_case,
                                 const std::string& metric, const placement::Scorecard& card,
                                 int level);

/// Per level of looseness, and last over all of them where there are several: a row for each site
/// and each metric of the scorecard, in their order; metrics that no site has are left out. A
/// case's value is its mean over donnings; derived metrics (placement/derived_metrics.h) that the
/// samples lack come from such means. Percentiles are those of scores (base/quantile.h). Intervals
/// draw all people, the same ones for all rows; NaN with fewer than two who have a value.
std::vector<std::vector<MetricPercentiles>> metric_percentiles(
    const StudyData& data, const std::vector<SiteTable>& sites, const placement::Scorecard& card,
    const BootstrapOptions& options = {});

}  // namespace loosefit::study
