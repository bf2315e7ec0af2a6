#include "loosefit/report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "loosefit/base/check.h"
#include "loosefit/report/html.h"
#include "loosefit/report/svg.h"

namespace loosefit::report {
namespace {

constexpr double kWidth = 560;
constexpr double kLeft = 66, kRight = 16, kTop = 14, kBottom = 46;
constexpr const char* kGrid = "stroke=\"#e3e7eb\"";
constexpr const char* kBorder = "stroke=\"#5b6670\"";
constexpr std::array<const char*, 6> kColours = {"#b3401f", "#2458a8", "#1d6b3a",
                                                 "#7a4fa3", "#a06c00", "#3c7d86"};

/// Data to pixels.
struct Axis {
  AxisTicks ticks;
  bool logarithmic;
  double from, to;  ///< pixels of low and high

  bool shows(double value) const { return std::isfinite(value) && (!logarithmic || value > 0); }
  double at(double scaled) const {
    return from + (scaled - ticks.low) / (ticks.high - ticks.low) * (to - from);
  }
  double of(double value) const { return at(logarithmic ? std::log10(value) : value); }
  std::string label(double scaled) const {
    if (!logarithmic) return number(std::abs(scaled) < 1e-12 ? 0 : scaled, 4);
    const int decade = static_cast<int>(std::lround(scaled));
    if (decade >= -2 && decade <= 3) return number(std::pow(10.0, decade), 4);
    return fmt::format("10<tspan dy=\"-4\" font-size=\"8\">{}</tspan>", number(decade));
  }
};

/// Grid lines, tick labels, the two axes and their names.
std::string frame(const Plot& plot, const Axis& x, const Axis& y) {
  const double bottom = plot.height - kBottom, right = kWidth - kRight;
  std::string svg;
  for (const double t : x.ticks.at) {
    svg += svg_line(x.at(t), kTop, x.at(t), bottom, kGrid);
    svg += svg_text(x.at(t), bottom + 16, "middle", x.label(t));
  }
  for (const double t : y.ticks.at) {
    svg += svg_line(kLeft, y.at(t), right, y.at(t), kGrid);
    svg += svg_text(kLeft - 6, y.at(t) + 4, "end", y.label(t));
  }
  svg += svg_line(kLeft, bottom, right, bottom, kBorder);
  svg += svg_line(kLeft, kTop, kLeft, bottom, kBorder);
  svg += svg_text(0.5 * (kLeft + right), plot.height - 8, "middle", escaped(plot.x_label));
  const double middle = 0.5 * (kTop + bottom);
  svg += svg_text(14, middle, "middle", escaped(plot.y_label),
                  fmt::format(" transform=\"rotate(-90 14 {:.1f})\"", middle));
  return svg;
}

/// A mark of its own for every obtained series, so that they differ without colour too.
std::string mark(int kind, double x, double y, const char* colour) {
  constexpr double r = 3.6;
  switch (kind % 3) {
    case 0:
      return fmt::format(
          "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"none\" stroke=\"{}\" "
          "stroke-width=\"1.6\"/>\n",
          x, y, r, colour);
    case 1:
      return fmt::format(
          "<path d=\"M{:.1f} {:.1f}l{r} {r}M{:.1f} {:.1f}l{r} -{r}\" stroke=\"{}\" "
          "stroke-width=\"1.6\"/>\n",
          x - r, y - r, x - r, y + r, colour, fmt::arg("r", 2 * r));
    default:
      return fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\" fill=\"none\" "
          "stroke=\"{}\" stroke-width=\"1.6\"/>\n",
          x - r, y - r, 2 * r, 2 * r, colour);
  }
}

std::string curve(const Plot::Series& series, const Axis& x, const Axis& y, const char* colour) {
  std::string points;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i)
    if (x.shows(series.x[i]) && y.shows(series.y[i]))
      points += fmt::format("{:.1f},{:.1f} ", x.of(series.x[i]), y.of(series.y[i]));
  return fmt::format(
      "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\" "
      "stroke-opacity=\"0.75\"/>\n",
      points, colour);
}

}  // namespace

AxisTicks axis_ticks(const std::vector<double>& values, bool logarithmic) {
  LOOSEFIT_ASSERT(!values.empty() && std::all_of(values.begin(), values.end(), [&](double v) {
    return std::isfinite(v) && (v > 0 || !logarithmic);
  }));
  double low = *std::min_element(values.begin(), values.end());
  double high = *std::max_element(values.begin(), values.end());
  AxisTicks ticks;
  if (logarithmic) {
    ticks.low = std::floor(std::log10(low) + 1e-9);
    ticks.high = std::max(std::ceil(std::log10(high) - 1e-9), ticks.low + 1);
    const double step = std::ceil((ticks.high - ticks.low) / 9);
    for (double t = ticks.low; t <= ticks.high + 1e-9; t += step) ticks.at.push_back(t);
    return ticks;
  }
  if (!(high > low)) {  // a single value: give it room
    const double room = std::max(0.1 * std::abs(low), 1e-9);
    low -= room;
    high += room;
  }
  const double rough = (high - low) / 6, power = std::pow(10.0, std::floor(std::log10(rough)));
  const double share = rough / power;
  const double step = power * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
  ticks.low = step * std::floor(low / step + 1e-9);
  ticks.high = step * std::ceil(high / step - 1e-9);
  const int count = static_cast<int>(std::lround((ticks.high - ticks.low) / step));
  for (int i = 0; i <= count; ++i) ticks.at.push_back(ticks.low + i * step);
  return ticks;
}

std::string svg_plot(const Plot& plot) {
  // What can be drawn decides the range of the axes.
  std::vector<double> xs, ys;
  for (const auto& s : plot.series)
    for (std::size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i) {
      const bool bad_x = !std::isfinite(s.x[i]) || (plot.log_x && s.x[i] <= 0);
      const bool bad_y = !std::isfinite(s.y[i]) || (plot.log_y && s.y[i] <= 0);
      if (bad_x || bad_y) continue;
      xs.push_back(s.x[i]);
      ys.push_back(s.y[i]);
    }
  if (xs.empty()) return {};
  const Axis x{axis_ticks(xs, plot.log_x), plot.log_x, kLeft, kWidth - kRight};
  const Axis y{axis_ticks(ys, plot.log_y), plot.log_y, plot.height - kBottom, kTop};

  const double legend = 16 * static_cast<double>(plot.series.size()) + 6;
  std::string svg = svg_open(kWidth, plot.height + legend, plot.title) + frame(plot, x, y);
  int references = 0, obtained = 0;
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const Plot::Series& s = plot.series[k];
    const double row = plot.height + 8 + 16 * static_cast<double>(k);
    // A reference and the points held against it come in pairs: the same colour for both.
    const char* colour = kColours[(s.reference ? references : obtained) % kColours.size()];
    if (s.reference) {
      svg += curve(s, x, y, colour) +
             svg_line(kLeft, row, kLeft + 22, row,
                      fmt::format("stroke=\"{}\" stroke-width=\"1.5\"", colour));
      ++references;
    } else {
      for (std::size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i)
        if (x.shows(s.x[i]) && y.shows(s.y[i]))
          svg += mark(obtained, x.of(s.x[i]), y.of(s.y[i]), colour);
      svg += mark(obtained, kLeft + 11, row, colour);
      ++obtained;
    }
    svg += svg_text(kLeft + 30, row + 4, "start", escaped(s.name));
  }
  return svg + "</svg>\n";
}

}  // namespace loosefit::report
