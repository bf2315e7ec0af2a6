#include "loosefit/render/image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace loosefit::render {
namespace {

/// The mean of four values in linear light, computed without tables.
std::uint8_t mean_of(const std::array<std::uint8_t, 4>& values) {
  float sum = 0;
  for (const std::uint8_t v : values) sum += static_cast<float>(std::pow(v / 255.0, 2.2));
  return static_cast<std::uint8_t>(std::lround(255 * std::pow(sum * 0.25f, 1 / 2.2)));
}

TEST(ScaledDown, AveragesInLinearLight) {
  std::mt19937 rng(1);
  std::uniform_int_distribution<int> any(0, 255), near(-2, 2);
  for (int i = 0; i < 20000; ++i) {
    Image image(2, 2);
    std::array<std::uint8_t, 4> values{};
    const int middle = any(rng);  // most blocks of a picture are of about one colour
    for (int k = 0; k < 4; ++k)
      values[k] =
          static_cast<std::uint8_t>(i % 2 == 0 ? any(rng) : std::clamp(middle + near(rng), 0, 255));
    for (int k = 0; k < 4; ++k) image.pixels[k] = {values[k], 0, 255};
    const Image small = scaled_down(image, 2);
    ASSERT_EQ(small.pixels.size(), 1u);
    ASSERT_EQ(small.pixels[0], (Rgb{mean_of(values), 0, 255}));
  }
}

TEST(ScaledDown, KeepsImagesOfOneColour) {
  for (int factor : {1, 2, 3})
    for (int v = 0; v < 256; ++v) {
      const auto level = static_cast<std::uint8_t>(v);
      const Image image(2 * factor, factor, {level, level, level});
      for (const Rgb& p : scaled_down(image, factor).pixels)
        ASSERT_EQ(p, (Rgb{level, level, level})) << factor;
    }
}

}  // namespace
}  // namespace loosefit::render
