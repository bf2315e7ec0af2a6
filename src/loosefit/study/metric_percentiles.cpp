#include "loosefit/study/metric_percentiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "loosefit/base/quantile.h"
#include "loosefit/placement/derived_metrics.h"
#include "loosefit/placement/resample.h"
#include "loosefit/study/population_ranking.h"

namespace loosefit::study {
namespace {

/// Of all criteria of a metric the least ramp.
double ramp_of(const placement::Scorecard& card, const std::string& metric, double value) {
  double least = std::numeric_limits<double>::infinity();
  for (const placement::Criterion& criterion : card.criteria)
    if (criterion.metric == metric) least = std::min(least, criterion.ramp(value));
  return least;
}

/// What the criteria judge, each once.
std::vector<std::string> metrics_of(const placement::Scorecard& card) {
  std::vector<std::string> metrics;
  for (const placement::Criterion& criterion : card.criteria)
    if (std::find(metrics.begin(), metrics.end(), criterion.metric) == metrics.end())
      metrics.push_back(criterion.metric);
  return metrics;
}

/// Values of a site by metric and case.
std::vector<std::vector<double>> values_by_case(const SiteTable& site,
                                                const std::vector<std::string>& metrics,
                                                const placement::Scorecard& card) {
  const std::size_t cases = site.by_case.size();
  std::vector<std::vector<double>> values(metrics.size(), std::vector<double>(cases, kNotKnown));
  for (std::size_t c = 0; c < cases; ++c) {
    placement::MetricValues measured;
    for (const auto& [metric, by_case] : site.metrics)
      if (!std::isnan(by_case[c])) measured[metric] = by_case[c];
    // Some metrics follow from the sensor alone, also where it was not measured.
    if (measured.empty()) continue;
    const placement::MetricValues all =
        placement::with_derived(measured, card.parameters, card.footprint);
    for (std::size_t m = 0; m < metrics.size(); ++m)
      if (const auto value = all.find(metrics[m]); value != all.end()) values[m][c] = value->second;
  }
  return values;
}

struct Percentiles {
  double median = kNotKnown, p5 = kNotKnown, p95 = kNotKnown;
};

Percentiles percentiles_of(const std::vector<double>& ascending) {
  const std::size_t n = ascending.size();
  if (n == 0) return {};
  return {0.5 * (ascending[(n - 1) / 2] + ascending[n / 2]),
          ascending[quantile_index(n, kRobustPeople)], ascending[robust_index_from_above(n)]};
}

/// How often each unit is in each draw of a bootstrap.
std::vector<std::vector<int>> drawn_times(int units, const BootstrapOptions& options) {
  std::vector<std::vector<int>> draws;
  if (units < 2) return draws;
  for (const std::vector<int>& draw :
       placement::bootstrap_draws(units, options.resamples, options.seed)) {
    std::vector<int>& times = draws.emplace_back(units, 0);
    for (const int unit : draw) ++times[unit];
  }
  return draws;
}

void add_percentiles(const std::vector<double>& by_unit, const std::vector<std::vector<int>>& drawn,
                     double confidence, MetricPercentiles& row) {
  std::vector<std::pair<double, std::size_t>> known;
  for (std::size_t u = 0; u < by_unit.size(); ++u)
    if (!std::isnan(by_unit[u])) known.emplace_back(by_unit[u], u);
  std::sort(known.begin(), known.end());
  std::vector<double> ascending;
  for (const auto& [value, unit] : known) ascending.push_back(value);
  const Percentiles all = percentiles_of(ascending);
  row.known = static_cast<int>(known.size());
  row.median = all.median;
  row.p5 = all.p5;
  row.p95 = all.p95;
  if (known.size() < 2) return;
  // A draw that goes through the people in the order of their values needs no sorting.
  std::vector<double> medians, lows, highs;
  for (const std::vector<int>& times : drawn) {
    ascending.clear();
    for (const auto& [value, unit] : known) ascending.insert(ascending.end(), times[unit], value);
    const Percentiles draw = percentiles_of(ascending);
    medians.push_back(draw.median);
    lows.push_back(draw.p5);
    highs.push_back(draw.p95);
  }
  row.median_interval = percentile_bounds(std::move(medians), confidence);
  row.p5_interval = percentile_bounds(std::move(lows), confidence);
  row.p95_interval = percentile_bounds(std::move(highs), confidence);
}

void count_cases(const StudyData& data, const std::vector<double>& by_case, int level,
                 MetricPercentiles& row) {
  for (std::size_t c = 0; c < by_case.size(); ++c) {
    if (level >= 0 && data.level_of_case[c] != level) continue;
    ++row.cases;
    row.known_cases += !std::isnan(by_case[c]);
  }
}

}  // namespace

std::vector<double> unit_metrics(const StudyData& data, const std::vector<double>& by_case,
                                 const std::string& metric, const placement::Scorecard& card,
                                 int level) {
  std::vector<double> values(data.units.size(), kNotKnown);
  for (std::size_t c = 0; c < by_case.size(); ++c) {
    if (std::isnan(by_case[c]) || (level >= 0 && data.level_of_case[c] != level)) continue;
    double& value = values[data.unit_of_case[c]];
    if (std::isnan(value) || ramp_of(card, metric, by_case[c]) < ramp_of(card, metric, value))
      value = by_case[c];
  }
  return values;
}

std::vector<std::vector<MetricPercentiles>> metric_percentiles(const StudyData& data,
                                                               const std::vector<SiteTable>& sites,
                                                               const placement::Scorecard& card,
                                                               const BootstrapOptions& options) {
  const std::vector<std::string> metrics = metrics_of(card);
  std::vector<std::vector<std::vector<double>>> values;  // by site, metric and case
  std::vector<char> told(metrics.size(), 0);
  for (const SiteTable& site : sites) {
    values.push_back(values_by_case(site, metrics, card));
    for (std::size_t m = 0; m < metrics.size(); ++m)
      told[m] |= std::any_of(values.back()[m].begin(), values.back()[m].end(),
                             [](double value) { return !std::isnan(value); });
  }
  const std::vector<std::vector<int>> drawn =
      drawn_times(static_cast<int>(data.units.size()), options);
  std::vector<int> levels;
  for (std::size_t level = 0; level < data.level_bgm.size(); ++level)
    levels.push_back(static_cast<int>(level));
  if (levels.size() > 1) levels.push_back(-1);
  std::vector<std::vector<MetricPercentiles>> by_level;
  for (const int level : levels) {
    std::vector<MetricPercentiles>& rows = by_level.emplace_back();
    for (std::size_t s = 0; s < sites.size(); ++s)
      for (std::size_t m = 0; m < metrics.size(); ++m) {
        if (!told[m]) continue;
        MetricPercentiles& row = rows.emplace_back();
        row.site = sites[s].site;
        row.metric = metrics[m];
        count_cases(data, values[s][m], level, row);
        add_percentiles(unit_metrics(data, values[s][m], metrics[m], card, level), drawn,
                        options.confidence, row);
        row.people = asked_units(data, level);
      }
  }
  return by_level;
}

}  // namespace loosefit::study
