#pragma once
#include <cstdint>
#include <functional>
#include <vector>

namespace loosefit::study {

/// How intervals are made: percentile bootstrap (Efron 1979) over people, all that belongs to one
/// person drawn together, since two donnings of one person tell less than those of two.
struct BootstrapOptions {
  std::uint64_t seed = 1;
  int resamples = 2000;  ///< 0: no interval
  double confidence = 0.90;
};

struct Bounds {
  double low = 0, high = 0;
};

/// Interval of a statistic of n people: `statistic` gets the indices of a draw. Values may be
/// infinite (no such limit within the range that was looked at) and sort as such; draws that give
/// NaN are left out. NaN bounds without a draw that counts.
Bounds bootstrap(int n, const std::function<double(const std::vector<int>&)>& statistic,
                 const BootstrapOptions& options = {});

/// The interval of values that were drawn already.
Bounds percentile_bounds(std::vector<double> values, double confidence);

/// How sure one may be that at least `share` of a population lies above the worst of n independent
/// people, whatever the distribution: 1 − share^n (Wilks 1941). 0.951 for 59 people and 95 %.
double worst_of_n_confidence(int n, double share);

/// Correlation of ranks (Spearman 1904), equal values with their mean rank; NaN for fewer than
/// three pairs or when one side is constant. Pairs with a NaN are left out.
double rank_correlation(const std::vector<double>& x, const std::vector<double>& y);

/// Share of the variance of y that the groups explain by themselves, ε² = (SS_between − (k − 1)
/// MS_within) / SS_total, which has no bias from small groups to first order (Kelley 1935); not
/// below 0. In a balanced crossed design this is the first-order index of variance-based
/// sensitivity (Sobol 1993). NaN for fewer than two groups, or when y is constant.
double main_effect(const std::vector<int>& group, const std::vector<double>& y);

}  // namespace loosefit::study
