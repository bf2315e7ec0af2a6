#include "loosefit/validate/correlation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/base/error.h"

namespace loosefit::validate {
namespace {

TEST(FitLine, FindsTheLineAndHowMuchItExplains) {
  const Line exact = fit_line({0, 1, 2, 5}, {3, 5, 7, 13});
  EXPECT_NEAR(exact.slope, 2, 1e-12);
  EXPECT_NEAR(exact.intercept, 3, 1e-12);
  EXPECT_NEAR(exact.r2, 1, 1e-12);
  // Σ(x − 1)(y − 1) = 1, Σ(x − 1)² = 2, Σ(y − 1)² = 2: r² = 1/4.
  const Line loose = fit_line({0, 1, 2}, {0, 2, 1});
  EXPECT_NEAR(loose.slope, 0.5, 1e-12);
  EXPECT_NEAR(loose.r2, 0.25, 1e-12);
  EXPECT_THROW(fit_line({1, 1}, {0, 1}), InvalidInput);
  EXPECT_THROW(fit_line({1, 2, 3}, {0, 1}), InvalidInput);
}

TEST(RankCorrelation, SeesOrderAloneAndSharesTiedRanks) {
  EXPECT_NEAR(rank_correlation({1, 2, 3, 4}, {10, 100, 1000, 1e9}), 1, 1e-12);
  EXPECT_NEAR(rank_correlation({1, 2, 3, 4}, {9, 7, 1, 0}), -1, 1e-12);
  // 1 − 6 Σd²/(n (n² − 1)) = 1 − 6·2/(5·24): two neighbours swapped.
  EXPECT_NEAR(rank_correlation({1, 2, 3, 4, 5}, {1, 3, 2, 4, 5}), 0.9, 1e-12);
  // Ranks 0, 1.5, 1.5, 3 against 0, 1, 2, 3.
  EXPECT_NEAR(rank_correlation({1, 2, 2, 3}, {1, 2, 3, 4}), std::sqrt(0.9), 1e-12);
  EXPECT_TRUE(std::isnan(rank_correlation({1, 1}, {0, 1})));
}

}  // namespace
}  // namespace loosefit::validate
