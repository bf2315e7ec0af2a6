#include "loosefit/render/lit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace loosefit::render {
namespace {

TEST(Lit, FullLightKeepsColoursAndNoShadeGoesBelowTheFloor) {
  const Rgb colour = {200, 120, 40};
  for (double floor : {0.25, 0.55, 0.8}) {
    Rgb darker = {0, 0, 0};
    for (int light = 0; light < 256; ++light) {
      const auto level = static_cast<std::uint8_t>(light);
      const Rgb shaded =
          lit(Image(1, 1, colour), Image(1, 1, {level, level, level}), floor).pixels[0];
      for (int k = 0; k < 3; ++k) {
        EXPECT_GE(shaded[k], std::floor(floor * colour[k])) << floor << " " << light;
        EXPECT_GE(shaded[k], darker[k]) << "more light is never darker";
      }
      darker = shaded;
    }
    EXPECT_EQ(darker, colour);
    EXPECT_EQ(lit(Image(1, 1, colour), Image(1, 1, {0, 0, 0}), floor).pixels[0][0],
              std::lround(200 * floor))
        << "the darkest crease is at the floor";
  }
}

TEST(Lit, BackgroundStaysWhiteInAnyShade) {
  const Rgb white = {255, 255, 255};
  EXPECT_EQ(lit(Image(1, 1, white), Image(1, 1, {30, 30, 30}), 0.55).pixels[0], white);
}

}  // namespace
}  // namespace loosefit::render
