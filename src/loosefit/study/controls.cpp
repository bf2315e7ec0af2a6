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
  Control control{true, "", {}};
  if (a.status != CaseStatus::done) {
    control.failed = a.reason.empty() ? "no result" : a.reason;
    return control;
  }
  for (const SampleRecord& x : b.samples)
    for (const SampleRecord& y : a.samples) {
      if (x.modality != y.modality || x.site != y.site || x.donning != y.donning) continue;
      if (std::isfinite(x.score) && std::isfinite(y.score))
        widen(control.largest, "score", std::abs(x.score - y.score));
      for (const auto& [metric, value] : x.metrics)
        if (const auto at = y.metrics.find(metric); at != y.metrics.end())
          if (std::isfinite(value) && std::isfinite(at->second))
            widen(control.largest, metric, std::abs(value - at->second));
    }
  return control;
}

void add(const Control& control, ControlSummary& summary) {
  if (!control.ran) return;
  ++summary.cases;
  summary.failed += !control.failed.empty();
  for (const auto& [metric, most] : control.largest) widen(summary.largest, metric, most);
}

}  // namespace loosefit::study
