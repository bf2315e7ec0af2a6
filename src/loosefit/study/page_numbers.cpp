#include "loosefit/study/page_numbers.h"

#include <algorithm>
#include <cmath>

#include "loosefit/placement/metric_names.h"
#include "loosefit/report/html.h"

namespace loosefit::study {

using report::fixed;

std::string score(double value) {
  return std::isnan(value) ? "–" : fixed(std::clamp(value, 0.0, 1.0), 2);
}
std::string bounds(const Bounds& b, int decimals) {
  if (std::isnan(b.low)) return "–";
  return fixed(b.low, decimals) + " to " + fixed(b.high, decimals);
}
std::string score_bounds(const Bounds& b) {
  return std::isnan(b.low) ? "–" : score(b.low) + " to " + score(b.high);
}
std::string percent(double share) { return std::isnan(share) ? "–" : fixed(100 * share, 0) + " %"; }

std::string metric_words(const std::string& metric) {
  const placement::MetricName* name = placement::find_metric(metric);
  return name ? name->words : metric;
}

}  // namespace loosefit::study
