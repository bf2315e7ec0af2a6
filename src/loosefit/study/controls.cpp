#include "loosefit/study/controls.h"

#include <algorithm>
#include <cmath>

namespace loosefit::study {
namespace {

constexpr unsigned long kOneIn = 20;

void widen(std::map<std::string, double>& largest, const std::string& metric, double by) {
  double& most = largest.try_emplace(metric, 0).first->second;
  most = std::max(most, by);
}

/// "twist_deg", and not "line_gain_percent_per_deg", which is a rate.
bool is_angle(const std::string& metric) {
  return metric.ends_with("_deg") && !metric.ends_with("_per_deg");
}

/// Angles go round: from 179° to −179° it is 2°.
double change(const std::string& metric, double x, double y) {
  const double by = std::abs(x - y);
  if (!is_angle(metric)) return by;
  const double turn = std::fmod(by, 360);
  return std::min(turn, 360 - turn);
}

bool same_sample(const SampleRecord& x, const SampleRecord& y) {
  return x.modality == y.modality && x.site == y.site && x.donning == y.donning;
}

/// A sample that one of the grades does not have at all has no score there.
ScoreChanges score_changes(const CaseRecord& b, const CaseRecord& a) {
  const auto rated_in = [](const CaseRecord& record, const SampleRecord& sample) {
    return std::ranges::any_of(record.samples, [&](const SampleRecord& other) {
      return same_sample(sample, other) && std::isfinite(other.score);
    });
  };
  ScoreChanges changes;
  for (const SampleRecord& sample : b.samples)
    if (std::isfinite(sample.score)) ++(rated_in(a, sample) ? changes.kept : changes.lost);
  for (const SampleRecord& sample : a.samples)
    if (std::isfinite(sample.score)) changes.gained += !rated_in(b, sample);
  return changes;
}

}  // namespace

std::vector<std::string> control_addresses(const std::vector<std::string>& addresses) {
  std::vector<std::string> chosen;
  for (const std::string& address : addresses)
    if (std::stoul(address.substr(0, 6), nullptr, 16) % kOneIn == 0) chosen.push_back(address);
  if (chosen.empty() && !addresses.empty())
    chosen.push_back(*std::min_element(addresses.begin(), addresses.end()));
  return chosen;
}

Control compared(const CaseRecord& b, const CaseRecord& a) {
  Control control{true, "", {}, {}};
  if (a.status != CaseStatus::done) {
    control.failed = a.reason.empty() ? "no result" : a.reason;
    return control;
  }
  for (const SampleRecord& x : b.samples)
    for (const SampleRecord& y : a.samples) {
      if (!same_sample(x, y)) continue;
      if (std::isfinite(x.score) && std::isfinite(y.score))
        widen(control.largest, "score", std::abs(x.score - y.score));
      for (const auto& [metric, value] : x.metrics)
        if (const auto at = y.metrics.find(metric); at != y.metrics.end())
          if (std::isfinite(value) && std::isfinite(at->second))
            widen(control.largest, metric, change(metric, value, at->second));
    }
  control.scores = score_changes(b, a);
  return control;
}

void add(const Control& control, ControlSummary& summary) {
  if (!control.ran) return;
  ++summary.cases;
  summary.failed += !control.failed.empty();
  for (const auto& [metric, most] : control.largest) widen(summary.largest, metric, most);
  if (!control.scores) return;
  ++summary.counted;
  summary.scores.kept += control.scores->kept;
  summary.scores.lost += control.scores->lost;
  summary.scores.gained += control.scores->gained;
}

}  // namespace loosefit::study
