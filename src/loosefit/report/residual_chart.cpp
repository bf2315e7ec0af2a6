#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/report/html.h"
#include "loosefit/report/sections.h"

namespace loosefit {
namespace {
constexpr double kWidth = 640, kHeight = 190, kLeft = 52, kRight = 12, kTop = 12, kBottom = 34;
}

std::string residual_chart(const std::vector<SettleSample>& history, double tolerance) {
  std::vector<std::pair<double, double>> points;  // seconds, log10 of the residual
  for (const SettleSample& sample : history)
    if (sample.residual > 0 && std::isfinite(sample.residual))
      points.emplace_back(sample.seconds, std::log10(sample.residual));
  if (points.size() < 2) return {};

  double low = std::log10(tolerance), high = low;
  for (const auto& [seconds, residual] : points) {
    low = std::min(low, residual);
    high = std::max(high, residual);
  }
  low = std::floor(low);
  high = std::max(std::ceil(high), low + 1);
  const double begin = points.front().first;
  const double span = std::max(points.back().first - begin, 1e-9);
  const auto x = [&](double s) { return kLeft + (s - begin) / span * (kWidth - kLeft - kRight); };
  const auto y = [&](double r) {
    return kTop + (high - r) / (high - low) * (kHeight - kTop - kBottom);
  };

  std::string svg = fmt::format(
      "<svg viewBox=\"0 0 {:.0f} {:.0f}\" style=\"max-width:{:.0f}px;width:100%\" role=\"img\" "
      "aria-label=\"Residual over time\">\n",
      kWidth, kHeight, kWidth);
  for (double decade = low; decade <= high; ++decade)
    svg += fmt::format(
        "<line x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#e3e7eb\"/>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">10<tspan dy=\"-4\" "
        "font-size=\"8\">{:.0f}</tspan></text>\n",
        kLeft, kWidth - kRight, y(decade), y(decade), kLeft - 6, y(decade) + 4, decade);
  svg += fmt::format(
      "<line x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#1d6b3a\" "
      "stroke-dasharray=\"5 4\"/><text x=\"{:.1f}\" y=\"{:.1f}\" "
      "text-anchor=\"start\">tolerance</text>\n",
      kLeft, kWidth - kRight, y(std::log10(tolerance)), y(std::log10(tolerance)), kLeft + 4,
      y(std::log10(tolerance)) + 13);
  std::string line;
  for (const auto& [seconds, residual] : points)
    line += fmt::format("{:.1f},{:.1f} ", x(seconds), y(residual));
  svg +=
      "<polyline points=\"" + line + "\" fill=\"none\" stroke=\"#2458a8\" stroke-width=\"1.5\"/>\n";
  svg += fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">residual over {} s of "
      "settling</text>\n",
      0.5 * (kLeft + kWidth), kHeight - 8, number(span, 3));
  return svg + "</svg>\n";
}

}  // namespace loosefit
