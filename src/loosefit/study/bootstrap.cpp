#include "loosefit/study/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "loosefit/base/quantile.h"
#include "loosefit/placement/resample.h"

namespace loosefit::study {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Ranks from 1, equal values with their mean.
std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<int> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return values[a] < values[b]; });
  std::vector<double> rank(values.size());
  for (std::size_t i = 0; i < order.size();) {
    std::size_t j = i;
    while (j < order.size() && values[order[j]] == values[order[i]]) ++j;
    for (std::size_t k = i; k < j; ++k)
      rank[order[k]] = 0.5 * (static_cast<double>(i) + static_cast<double>(j) + 1);
    i = j;
  }
  return rank;
}

}  // namespace

Bounds percentile_bounds(std::vector<double> values, double confidence) {
  std::erase_if(values, [](double v) { return std::isnan(v); });
  if (values.empty()) return {kNaN, kNaN};
  const double tail = 0.5 * (1 - confidence);
  return {quantile(values, tail), quantile(values, 1 - tail)};
}

Bounds bootstrap(int n, const std::function<double(const std::vector<int>&)>& statistic,
                 const BootstrapOptions& options) {
  if (n < 2) return {kNaN, kNaN};
  std::vector<double> values;
  for (const std::vector<int>& draw :
       placement::bootstrap_draws(n, options.resamples, options.seed))
    values.push_back(statistic(draw));
  return percentile_bounds(std::move(values), options.confidence);
}

double worst_of_n_confidence(int n, double share) { return 1 - std::pow(share, n); }

double rank_correlation(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> a, b;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (!std::isnan(x[i]) && !std::isnan(y[i])) {
      a.push_back(x[i]);
      b.push_back(y[i]);
    }
  if (a.size() < 3) return kNaN;
  a = ranks(a);
  b = ranks(b);
  const double mean = 0.5 * (static_cast<double>(a.size()) + 1);
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean) * (b[i] - mean);
    aa += (a[i] - mean) * (a[i] - mean);
    bb += (b[i] - mean) * (b[i] - mean);
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : kNaN;
}

double main_effect(const std::vector<int>& group, const std::vector<double>& y) {
  struct Sum {
    double sum = 0;
    int count = 0;
  };
  std::map<int, Sum> groups;
  Sum all;
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (std::isnan(y[i])) continue;
    Sum& own = groups[group[i]];
    own.sum += y[i];
    ++own.count;
    all.sum += y[i];
    ++all.count;
  }
  const int k = static_cast<int>(groups.size());
  if (k < 2 || all.count <= k) return kNaN;
  const double mean = all.sum / all.count;
  double total = 0, between = 0;
  for (std::size_t i = 0; i < y.size(); ++i)
    if (!std::isnan(y[i])) total += (y[i] - mean) * (y[i] - mean);
  for (const auto& [name, one] : groups) {
    const double off = one.sum / one.count - mean;
    between += one.count * off * off;
  }
  if (!(total > 0)) return kNaN;
  const double within = (total - between) / (all.count - k);
  return std::clamp((between - (k - 1) * within) / total, 0.0, 1.0);
}

}  // namespace loosefit::study
