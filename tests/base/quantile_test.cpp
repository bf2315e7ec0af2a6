#include "loosefit/base/quantile.h"

#include <gtest/gtest.h>

#include <cmath>

namespace loosefit {
namespace {

TEST(Quantile, IsTheOrderStatistic) {
  EXPECT_EQ(quantile({3, 1, 2}, 0.05), 1);
  std::vector<double> twenty, forty;
  for (int i = 1; i <= 40; ++i) (i <= 20 ? twenty : forty).push_back(i);
  EXPECT_EQ(quantile(twenty, 0.05), 1) << "5 % of 20 is one: the worst";
  forty.insert(forty.end(), twenty.begin(), twenty.end());
  EXPECT_EQ(quantile(forty, 0.05), 2);
  EXPECT_EQ(quantile(forty, 0.95), 38);
  EXPECT_EQ(quantile(forty, 1), 40);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
  EXPECT_EQ(median({4, 1, 3, 2}), 2.5);
  EXPECT_EQ(median({9, 1, 2}), 2);
}

TEST(Quantile, OfWeightsIsWhereTheShareOfTheWeightIsReached) {
  const std::vector<double> values = {5, 1, 3}, weights = {1, 2, 7};
  const std::vector<int> ascending = {1, 2, 0};
  EXPECT_EQ(weighted_quantile(values, weights, ascending, 10, 0.2), 1);
  EXPECT_EQ(weighted_quantile(values, weights, ascending, 10, 0.21), 3);
  EXPECT_EQ(weighted_quantile(values, weights, ascending, 10, 0.9), 3);
  EXPECT_EQ(weighted_quantile(values, weights, ascending, 10, 0.91), 5);
}

}  // namespace
}  // namespace loosefit
