#include "loosefit/placement/scorecard.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/base/text.h"
#include "loosefit/placement/derived_metrics.h"

namespace loosefit::placement {
namespace {

std::optional<double> known(const MetricValues& metrics, const std::string& name) {
  const auto at = metrics.find(name);
  if (at == metrics.end() || !std::isfinite(at->second)) return std::nullopt;
  return at->second;
}

std::string told(const Criterion& criterion, double value) {
  bool above = false;
  const double q = criterion.ramp(value, &above);
  const Ramp& ramp = above ? *criterion.upper : criterion.limit;
  const MetricName* metric = find_metric(criterion.metric);
  const std::string unit = metric && metric->unit != "-" ? " " + metric->unit : "";
  const std::string good =
      fmt::format("good {} {:g}", ramp.good > ramp.fail ? "from" : "to", ramp.good);
  if (q >= 1)
    return fmt::format("all needs met; nearest: {} {:.3g}{}, {}",
                       metric ? metric->words : criterion.metric, value, unit, good);
  return fmt::format("{}: {:.3g}{}, {}, fails at {:g}",
                     above ? criterion.reason_above : criterion.reason, value, unit, good,
                     ramp.fail);
}

std::string not_rated(const std::vector<std::string>& missing) {
  std::vector<std::string> needs;
  for (const std::string& metric : missing) needs.push_back(metric_with_need(metric));
  return "not rated: needs " + join(needs);
}

}  // namespace

double Criterion::ramp(double value, bool* above) const {
  const double below = limit.at(value);
  const double over = upper ? upper->at(value) : std::numeric_limits<double>::infinity();
  if (above) *above = over < below;
  return std::min(below, over);
}

Outlook outlook(const Criterion& criterion, double pass, double low, double high) {
  const bool low_passes = criterion.ramp(low) >= pass, high_passes = criterion.ramp(high) >= pass;
  if (low_passes && high_passes) return Outlook::passes;  // those that pass are an interval
  const auto inside = [&](const Ramp& ramp) {
    const double mark = ramp.fail + pass * (ramp.good - ramp.fail);
    return mark > low && mark < high;
  };
  return low_passes || high_passes || inside(criterion.limit) ||
                 (criterion.upper && inside(*criterion.upper))
             ? Outlook::open
             : Outlook::fails;
}

Score score(const MetricValues& metrics, const Scorecard& scorecard) {
  const MetricValues all = with_derived(metrics, scorecard.parameters, scorecard.footprint);
  Score result;
  result.margin = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < scorecard.criteria.size(); ++i) {
    const Criterion& criterion = scorecard.criteria[i];
    const auto value = known(all, criterion.metric);
    if (!value) {
      if (std::find(result.missing.begin(), result.missing.end(), criterion.metric) ==
          result.missing.end())
        result.missing.push_back(criterion.metric);
      continue;
    }
    const double ramp = criterion.ramp(*value);
    if (ramp >= result.margin) continue;
    result.margin = ramp;
    result.limiting = static_cast<int>(i);
    result.reason = told(criterion, *value);
  }
  result.bound = std::clamp(result.margin, 0.0, 1.0);
  if (result.missing.empty())
    result.q = result.bound;
  else
    result.reason = not_rated(result.missing);
  return result;
}

Scorecard known_part(const Scorecard& scorecard, const MetricValues& metrics) {
  const MetricValues all = with_derived(metrics, scorecard.parameters, scorecard.footprint);
  Scorecard part = scorecard;
  part.criteria.clear();
  for (const Criterion& criterion : scorecard.criteria) {
    if (known(all, criterion.metric))
      part.criteria.push_back(criterion);
    else
      part.left_out.push_back(criterion.metric);
  }
  return part;
}

}  // namespace loosefit::placement
