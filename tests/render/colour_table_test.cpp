#include "loosefit/render/colour_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace loosefit::render {
namespace {

double luminance(const Rgb& c) {
  const auto linear = [](double v) { return std::pow(v / 255, 2.2); };
  return 0.2126 * linear(c[0]) + 0.7152 * linear(c[1]) + 0.0722 * linear(c[2]);
}

int step(const Rgb& a, const Rgb& b) {
  int sum = 0;
  for (int k = 0; k < 3; ++k) sum += std::abs(int{a[k]} - int{b[k]});
  return sum;
}

TEST(ColourTable, SequentialRisesInLightnessAndHasNoBands) {
  const ColourTable& table = sequential_colours();
  for (int i = 1; i < 256; ++i) {
    EXPECT_GE(luminance(table[i]), luminance(table[i - 1]) - 0.004) << i;
    EXPECT_LE(step(table[i], table[i - 1]), 12) << i;
  }
  for (int i = 16; i < 256; i += 16) EXPECT_GT(luminance(table[i]), luminance(table[i - 16])) << i;
}

TEST(ColourTable, SequentialIsCloseToViridis) {
  const ColourTable& table = sequential_colours();
  EXPECT_LE(step(table[0], {0x44, 0x01, 0x54}), 3);
  EXPECT_LE(step(table[127], {0x21, 0x91, 0x8c}), 40);
  EXPECT_LE(step(table[255], {0xfd, 0xe7, 0x25}), 3);
}

TEST(ColourTable, DivergingIsBalancedAboutItsLightMiddle) {
  const ColourTable& table = diverging_colours();
  for (int i = 0; i < 128; ++i)
    EXPECT_NEAR(std::cbrt(luminance(table[i])), std::cbrt(luminance(table[255 - i])), 0.06) << i;
  EXPECT_GT(luminance(table[127]), 0.8);
  EXPECT_GT(table[0][2], table[0][0]);      // blue below zero
  EXPECT_GT(table[255][0], table[255][2]);  // red above
}

TEST(ColourTable, ValuesOutsideTheRangeAreAtItsEnds) {
  maps::PerformanceMap map;
  map.range_low = -1;
  map.range_high = 1;
  EXPECT_EQ(colour_share(map, -5), 0);
  EXPECT_EQ(colour_share(map, 0.5), 0.75);
  EXPECT_EQ(colour_share(map, 5), 1);
  EXPECT_TRUE(std::isnan(colour_share(map, std::nan(""))));
}

TEST(ColourTable, MapsWithASignTakeTheDivergingColours) {
  maps::PerformanceMap map;
  EXPECT_EQ(&colours_of(map), &sequential_colours());
  map.diverging = true;
  EXPECT_EQ(&colours_of(map), &diverging_colours());
}

TEST(ColourTable, BreaksLieAtEqualStepsOfTheBar) {
  maps::PerformanceMap map;
  map.range_high = 4;
  map.breaks = {0, 0.3, 0.7, 2.7, 4};
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(colour_share(map, map.breaks[i]), 0.25 * i, 1e-12);
  EXPECT_NEAR(colour_share(map, 0.15), 0.125, 1e-12);
  EXPECT_NEAR(colour_share(map, 1.7), 0.625, 1e-12);
  EXPECT_EQ(colour_share(map, -1), 0);
  EXPECT_EQ(colour_share(map, 99), 1);
  EXPECT_TRUE(std::isnan(colour_share(map, std::nan(""))));
}

}  // namespace
}  // namespace loosefit::render
