#include "loosefit/render/lit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace loosefit::render {

Image lit(Image colours, const Image& light, double ambient) {
  const double gain = (1 - ambient) / (1 - kSceneAmbient);
  std::vector<std::array<std::uint8_t, 256>> shaded(256);  // by light and channel
  for (int i = 0; i < 256; ++i) {
    const double factor = std::clamp(ambient + gain * (i / 255.0 - kSceneAmbient), ambient, 1.0);
    for (int c = 0; c < 256; ++c) shaded[i][c] = static_cast<std::uint8_t>(std::lround(c * factor));
  }
  constexpr Rgb kBackground = {255, 255, 255};  // occlusion reaches round the frame's edge into it
  for (std::size_t i = 0; i < colours.pixels.size(); ++i) {
    if (colours.pixels[i] == kBackground) continue;
    const auto& row = shaded[light.pixels[i][1]];
    for (std::uint8_t& channel : colours.pixels[i]) channel = row[channel];
  }
  return colours;
}

}  // namespace loosefit::render
