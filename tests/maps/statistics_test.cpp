#include "loosefit/maps/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace loosefit::maps {
namespace {

TEST(Statistics, UniformDistributionHasItsQuantiles) {
  std::vector<double> values, weights;
  for (int i = 0; i < 1000; ++i) {
    values.push_back((i * 7919 % 1000 + 0.5) / 1000);  // every value once, in mixed order
    weights.push_back(2.5e-4);
  }
  const MapStatistics s = statistics(values, weights);
  EXPECT_NEAR(s.min, 0.0005, 1e-12);
  EXPECT_NEAR(s.max, 0.9995, 1e-12);
  EXPECT_NEAR(s.p5, 0.05, 0.001);
  EXPECT_NEAR(s.median, 0.5, 0.001);
  EXPECT_NEAR(s.p95, 0.95, 0.001);
  EXPECT_NEAR(s.area_mean, 0.5, 1e-12);
  EXPECT_NEAR(s.area, 0.25, 1e-12);
}

TEST(Statistics, AreaCountsNotVertices) {
  // One large element at 10, nine small ones at 0.
  std::vector<double> values(10, 0.0), weights(10, 0.01);
  values[4] = 10;
  weights[4] = 0.91;
  const MapStatistics s = statistics(values, weights);
  EXPECT_EQ(s.median, 10);
  EXPECT_EQ(s.p5, 0);
  EXPECT_NEAR(s.area_mean, 9.1, 1e-12);
}

TEST(Statistics, UndefinedValuesAreCountedApart) {
  const MapStatistics s = statistics({std::nan(""), 3, std::nan("")}, {1, 2, 3});
  EXPECT_EQ(s.undefined, 2);
  EXPECT_EQ(s.median, 3);
  EXPECT_EQ(s.area, 2);
  EXPECT_TRUE(std::isnan(statistics({std::nan("")}, {1}).median));
  EXPECT_TRUE(std::isnan(statistics({}, {}).area_mean));
}

TEST(Statistics, RegionsKeepToThemselves) {
  const auto found = regional_statistics(
      {1, 2, 3, std::nan("")}, {1, 1, 2, 1},
      {body::Region::chest, body::Region::abdomen, body::Region::abdomen, body::Region::side_left});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found.at(body::Region::chest).max, 1);
  EXPECT_NEAR(found.at(body::Region::abdomen).area_mean, 8.0 / 3, 1e-12);
}

}  // namespace
}  // namespace loosefit::maps
