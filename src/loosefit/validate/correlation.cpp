#include "loosefit/validate/correlation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "loosefit/base/error.h"

namespace loosefit::validate {
namespace {

/// Sums of squares and products about the means.
struct Moments {
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0, yy = 0;

  Moments(const std::vector<double>& x, const std::vector<double>& y) {
    if (x.size() != y.size() || x.size() < 2)
      throw InvalidInput("correlation: " + std::to_string(x.size()) + " and " +
                         std::to_string(y.size()) + " values");
    const double n = static_cast<double>(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) mean_x += x[i] / n, mean_y += y[i] / n;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double u = x[i] - mean_x, v = y[i] - mean_y;
      xx += u * u, xy += u * v, yy += v * v;
    }
  }
};

std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> rank(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first;
    while (last + 1 < order.size() && values[order[last + 1]] == values[order[first]]) ++last;
    for (std::size_t k = first; k <= last; ++k)
      rank[order[k]] = 0.5 * static_cast<double>(first + last);
    first = last + 1;
  }
  return rank;
}

}  // namespace

Line fit_line(const std::vector<double>& x, const std::vector<double>& y) {
  const Moments m(x, y);
  if (!(m.xx > 0)) throw InvalidInput("a line through points of one x");
  Line line;
  line.slope = m.xy / m.xx;
  line.intercept = m.mean_y - line.slope * m.mean_x;
  line.r2 = m.yy > 0 ? m.xy * m.xy / (m.xx * m.yy) : 1;
  return line;
}

double rank_correlation(const std::vector<double>& x, const std::vector<double>& y) {
  const Moments m(ranks(x), ranks(y));
  if (!(m.xx > 0 && m.yy > 0)) return std::numeric_limits<double>::quiet_NaN();
  return m.xy / std::sqrt(m.xx * m.yy);
}

}  // namespace loosefit::validate
