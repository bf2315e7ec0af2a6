#pragma once
#include <cstddef>
#include <vector>

namespace loosefit {

/// Index of the quantile among n > 0 ascending values: that of the ⌈share · n⌉-th, the first at
/// least.
std::size_t quantile_index(std::size_t n, double share);
/// Smallest value such that at least `share` of the values lie at or below it: the
/// ⌈share · n⌉-th smallest. NaN without values.
double quantile(std::vector<double> values, double share);
/// Middle value, or the mean of the two in the middle. NaN without values.
double median(std::vector<double> values);

/// Smallest value such that at least the share `share` of the total weight lies at or below it.
/// `ascending` orders the indices of the values that count; their weights are positive.
/// \pre ascending is not empty.
double weighted_quantile(const std::vector<double>& values, const std::vector<double>& weights,
                         const std::vector<int>& ascending, double total, double share);

}  // namespace loosefit
