#pragma once
#include <string>

#include "loosefit/validate/benchmark.h"

namespace loosefit {

/// The plot as inline SVG: reference series as lines, obtained ones as marks, axes with ticks
/// (decades where logarithmic), labels and a legend. Points that are not finite, or not positive
/// on a logarithmic axis, are left out; empty when nothing is left.
std::string svg_plot(const Plot& plot);

/// Where the ticks of an axis go.
struct AxisTicks {
  double low = 0, high = 1;  ///< range of the axis in its own scale (log10 where logarithmic)
  std::vector<double> at;    ///< in the same scale
};
/// Ticks at round numbers that span the values: steps of 1, 2 or 5 times a power of ten, or whole
/// decades. \pre all values are finite, and positive where logarithmic
AxisTicks axis_ticks(const std::vector<double>& values, bool logarithmic);

}  // namespace loosefit
