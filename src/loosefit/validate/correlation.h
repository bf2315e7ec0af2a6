#pragma once
#include <vector>

namespace loosefit::validate {

/// Straight line y = intercept + slope x through points, by least squares.
struct Line {
  double intercept = 0, slope = 0;
  double r2 = 0;  ///< share of the variance of y that it explains; 1 for a y that does not vary
};
/// \throws InvalidInput for fewer than two points, or x that does not vary.
Line fit_line(const std::vector<double>& x, const std::vector<double>& y);

/// Spearman's rank correlation: 1 when both rise together, −1 when one falls as the other rises.
/// Equal values share the mean of their ranks. NaN when one of them does not vary.
/// \throws InvalidInput unless both have as many values.
double rank_correlation(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace loosefit::validate
