#include "loosefit/kinds/shirt/lay_bands.h"

#include <algorithm>

#include "loosefit/dress/front_neckline.h"

namespace loosefit::kinds {
namespace {

constexpr int kPoints = 12;

double length_of(const std::vector<Vec2>& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += (line[i] - line[i - 1]).norm();
  return sum;
}

/// The line so far outside of a rim: down the shoulders at its ends, straight down in its middle.
std::vector<Vec2> outside(const std::vector<Vec2>& rim, const ShirtFrame& frame, double width) {
  const Vec2 left = (frame.left.shoulder - frame.left.neck).normalized(),
             right = (frame.right.shoulder - frame.right.neck).normalized(), down(0, -1);
  std::vector<Vec2> line;
  for (int k = 0; k <= kPoints; ++k) {
    const double share = double(k) / kPoints, aside = std::abs(1 - 2 * share);
    const Vec2 way = aside * (share < 0.5 ? left : right) + (1 - aside) * down;
    const Vec2 at = k == kPoints ? rim.back() : cut_line(rim, 1 - share).second.front();
    line.push_back(at + width * way.normalized());
  }
  return line;
}

}  // namespace

std::pair<std::vector<Vec2>, std::vector<Vec2>> cut_line(const std::vector<Vec2>& line,
                                                         double last_share) {
  double rest = (1 - last_share) * length_of(line);
  std::size_t i = 1;
  while (i + 1 < line.size() && rest > (line[i] - line[i - 1]).norm()) {
    rest -= (line[i] - line[i - 1]).norm();
    ++i;
  }
  const Vec2 cut = line[i - 1] + rest * (line[i] - line[i - 1]).normalized();
  std::vector<Vec2> first(line.begin(), line.begin() + static_cast<long>(i)), last = {cut};
  first.push_back(cut);
  last.insert(last.end(), line.begin() + static_cast<long>(i), line.end());
  return {first, last};
}

NeckbandLines neckband_lines(const ShirtFrame& frame, double width, bool straight_neck) {
  NeckbandLines lines;
  lines.back_rim = {frame.left.neck, frame.right.neck};
  lines.front_rim = straight_neck ? lines.back_rim : frame.front_neck;
  lines.front_seam = width > 0 ? outside(lines.front_rim, frame, width) : lines.front_rim;
  lines.back_seam = width > 0 ? outside(lines.back_rim, frame, width) : lines.back_rim;
  return lines;
}

double band_width(const garment::Garment& shirt, const char* part) {
  const bool cuff = std::string(part).starts_with("cuff");
  const auto* end = shirt.find_part(part, cuff ? "top" : "end_L");
  return end ? dress::flat_length(shirt, *end) : 0;
}

}  // namespace loosefit::kinds
