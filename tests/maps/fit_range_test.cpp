// Colour ranges that follow the data.
#include "loosefit/maps/fit_range.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace loosefit::maps {
namespace {

/// Share of the weight within the range.
double held(const MapArrayStyle& style, const std::vector<double>& values,
            const std::vector<double>& weights) {
  double in = 0, all = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    all += weights[i];
    if (values[i] >= style.range_low && values[i] <= style.range_high) in += weights[i];
  }
  return in / all;
}

TEST(FitRange, HoldsNearlyAllOfTheClothBetweenRoundEnds) {
  std::mt19937_64 rng(7);
  for (int draw = 0; draw < 200; ++draw) {
    const double size = std::pow(10.0, std::uniform_real_distribution<double>(-4, 3)(rng));
    std::normal_distribution<double> normal(0, size);
    std::uniform_real_distribution<double> weight(0.1, 1);
    const bool diverging = draw % 2;
    std::vector<double> values, weights;
    for (int i = 0; i < 400; ++i) {
      values.push_back(diverging ? normal(rng) : std::abs(normal(rng)));
      weights.push_back(weight(rng));
    }
    values[3] = 1e4 * size;  // one torn triangle must not set the scale
    values[4] = std::nan("");
    weights[4] = 0;
    MapArrayStyle style;
    style.diverging = diverging;
    style.range_low = diverging ? -1e-6 : 0;
    style.range_high = 1e-6;
    fit_range(style, {value_spread(values, weights)});
    EXPECT_GE(held(style, values, weights), 0.95) << size;
    EXPECT_LT(style.range_high, 12 * size) << "and is not much wider";
    EXPECT_EQ(style.range_low, diverging ? -style.range_high : 0);
    const double mantissa =
        style.range_high / std::pow(10.0, std::floor(std::log10(style.range_high) + 1e-9));
    bool round = false;
    for (const double n : {1, 2, 4, 6, 8}) round = round || std::abs(mantissa - n) < 1e-9;
    EXPECT_TRUE(round) << style.range_high;
  }
}

TEST(FitRange, IsTheSameForAllDrapesThatAreCompared) {
  MapArrayStyle style;
  style.range_high = 40;
  fit_range(style, {{0, 3}, {0, 17}, {std::nan(""), std::nan("")}});
  EXPECT_EQ(style.range_high, 20);
}

TEST(FitRange, LimitsOfUseAndSharesStayAsTheyAre) {
  MapArrayStyle gap, share, strain;
  gap.range_high = 40;
  gap.breaks = {0, 0.5, 40};
  fit_range(gap, {{0, 3}});
  EXPECT_EQ(gap.range_high, 40);
  share.range_high = 1;
  fit_range(share, {{0, 0.01}});
  EXPECT_EQ(share.range_high, 1);
  strain.diverging = true;
  strain.range_low = -0.05;
  strain.range_high = 0.05;
  fit_range(strain, {{-1e-9, 1e-9}});
  EXPECT_NEAR(strain.range_high, 0.0006, 1e-12) << "noise is not coloured";
}

}  // namespace
}  // namespace loosefit::maps
