#include "loosefit/render/line_mark.h"

#include <algorithm>
#include <array>

namespace loosefit::render {

Rgb line_colour(std::size_t i) {
  static constexpr std::array<Rgb, 6> kColours = {
      {{0, 114, 178}, {213, 94, 0}, {0, 158, 115}, {204, 121, 167}, {86, 180, 233}, {230, 159, 0}}};
  return kColours[i % kColours.size()];
}

void draw_line_names(Image& image, const std::vector<LineMark>& lines) {
  const int size = std::max(11, image.height / 60), gap = size / 2;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const int y = gap + static_cast<int>(i) * (size + gap);
    fill(image, gap, y + size / 3, gap + 2 * size, y + size / 3 + std::max(2, size / 4),
         line_colour(i));
    draw_text(image, lines[i].name, gap + 2 * size + gap, y, size);
  }
}

}  // namespace loosefit::render
