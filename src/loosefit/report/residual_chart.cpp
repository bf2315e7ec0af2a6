#include "loosefit/report/residual_chart.h"

#include <cmath>

#include "loosefit/report/plot.h"

namespace loosefit::report {

std::string residual_chart(const std::vector<drape::SettleSample>& history, double tolerance) {
  Plot::Series residual{"residual", {}, {}, true};
  for (const drape::SettleSample& sample : history) {
    if (!(sample.residual > 0) || !std::isfinite(sample.residual)) continue;
    residual.x.push_back(sample.seconds - history.front().seconds);
    residual.y.push_back(sample.residual);
  }
  if (residual.x.size() < 2) return {};
  const Plot::Series limit{
      "tolerance", {residual.x.front(), residual.x.back()}, {tolerance, tolerance}, true};
  Plot plot{"Residual over time", "seconds of settling", "residual", false, true,
            {residual, limit}};
  plot.height = 230;
  return svg_plot(plot);
}

}  // namespace loosefit::report
