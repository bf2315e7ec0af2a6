#pragma once
#include <string>
#include <vector>

namespace loosefit::report {

/// Curves and points over two axes, for a page.
struct Plot {
  struct Series {
    std::string name;
    std::vector<double> x, y;
    bool reference = false;  ///< drawn as a line; others as marks
  };
  std::string title, x_label, y_label;
  bool log_x = false, log_y = false;
  std::vector<Series> series;
  double height = 360;  ///< [pixels] without the legend; the width is 560
};

/// The plot as inline SVG: reference series as lines, others as marks, axes with ticks
/// (decades where logarithmic), labels and a legend. Points that are not finite, or not positive
/// on a logarithmic axis, are left out; empty when nothing is left.
std::string svg_plot(const Plot& plot);

/// Where the ticks of an axis go.
struct AxisTicks {
  double low = 0, high = 1;  ///< range of the axis in its own scale (log10 where logarithmic)
  std::vector<double> at;    ///< in the same scale
};
/// Ticks at round numbers that span the values: steps of 1, 2 or 5 times a power of ten, or whole
/// decades. \pre there are values; all are finite, and positive where
/// logarithmic
AxisTicks axis_ticks(const std::vector<double>& values, bool logarithmic);

}  // namespace loosefit::report
