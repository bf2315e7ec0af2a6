#include "loosefit/study/draws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"

namespace loosefit::study {
namespace {

TEST(NormalQuantile, IsThatOfTheTables) {
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-14);
  EXPECT_NEAR(normal_quantile(0.95), 1.6448536269514722, 1e-14);
  EXPECT_NEAR(normal_quantile(1e-10), -6.361340902404056, 1e-12);
  EXPECT_DOUBLE_EQ(normal_quantile(0.5), 0);
}

TEST(NormalQuantile, InvertsTheDistribution) {
  for (const double p : {1e-12, 1e-4, 0.02, 0.3, 0.5, 0.87, 0.9999})
    EXPECT_NEAR(0.5 * std::erfc(-normal_quantile(p) / std::sqrt(2.0)), p, 1e-14 + 1e-12 * p);
}

TEST(NormalQuantile, RefusesTheEnds) {
  for (const double p : {0.0, 1.0, -0.1, std::nan("")})
    EXPECT_THROW(normal_quantile(p), InvalidInput);
}

TEST(Draws, HaveTheMomentsOfTheNormalDistribution) {
  Draws draws(3);
  constexpr int n = 200000;
  double sum = 0, squares = 0;
  for (int i = 0; i < n; ++i) {
    const double z = draws.normal();
    sum += z;
    squares += z * z;
  }
  EXPECT_NEAR(sum / n, 0, 4 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1, 4 * std::sqrt(2.0 / n));
}

TEST(Stratified, HasOneValueInEachPart) {
  std::vector<double> values = stratified(50, 7);
  EXPECT_FALSE(std::is_sorted(values.begin(), values.end()));
  std::sort(values.begin(), values.end());
  for (int i = 0; i < 50; ++i) {
    EXPECT_GT(values[i], i / 50.0);
    EXPECT_LT(values[i], (i + 1) / 50.0);
  }
}

TEST(Stratified, DependsOnTheSeedAlone) {
  EXPECT_EQ(stratified(20, 1), stratified(20, 1));
  EXPECT_NE(stratified(20, 1), stratified(20, 2));
  EXPECT_NE(seed_for(1, "person"), seed_for(1, "fit"));
}

}  // namespace
}  // namespace loosefit::study
