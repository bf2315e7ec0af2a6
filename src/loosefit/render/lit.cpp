#include "loosefit/render/lit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace loosefit::render {

Image lit(Image colours, const Image& light, double ambient) {
  const double gain = (1 - ambient) / (1 - kSceneAmbient);
  std::array<double, 256> factor{};
  for (int i = 0; i < 256; ++i)
    factor[i] = std::clamp(ambient + gain * (i / 255.0 - kSceneAmbient), ambient, 1.0);
  constexpr Rgb kBackground = {255, 255, 255};  // occlusion reaches round the frame's edge into it
  for (std::size_t i = 0; i < colours.pixels.size(); ++i)
    if (colours.pixels[i] != kBackground)
      for (std::uint8_t& channel : colours.pixels[i])
        channel = static_cast<std::uint8_t>(std::lround(channel * factor[light.pixels[i][1]]));
  return colours;
}

}  // namespace loosefit::render
