#include "loosefit/report/sewing_labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/report/sewing_marks.h"

namespace loosefit::report {
namespace {

constexpr double kLarge = 6, kSmall = 4, kLine = 5;  // font sizes and row [mm]
constexpr double kRing = 14;                         // between rings of places to try [mm]
constexpr int kRings = 5, kDirections = 16;
// What a place costs, in covered points: words over words are worst, far is better than covered.
constexpr double kOverWords = 200, kPerRing = 1.5;

/// Width of words in a sans-serif font, on the large side.
double width_of(const std::vector<std::string>& lines) {
  double width = 0, size = kLarge;
  for (const std::string& line : lines) {
    width = std::max(width, 0.58 * size * static_cast<double>(line.size()));
    size = kSmall;
  }
  return width;
}

}  // namespace

void SewingLabels::keep_off(const std::vector<Vec2>& points) {
  taken_.insert(taken_.end(), points.begin(), points.end());
}

double SewingLabels::cost(const Box& box) const {
  double cost = 0;
  for (const Vec2& p : taken_)
    cost += (p - box.low).minCoeff() > 0 && (box.high - p).minCoeff() > 0;
  for (const Box& other : boxes_)
    if ((box.high - other.low).minCoeff() > 0 && (other.high - box.low).minCoeff() > 0)
      cost += kOverWords;
  return cost;
}

std::string SewingLabels::place(const Vec2& centre, double radius, std::vector<std::string> lines) {
  std::erase(lines, "");
  const Vec2 size(width_of(lines), kLine * static_cast<double>(lines.size()) + 2);
  Box best{centre, centre};
  double least = std::numeric_limits<double>::infinity();
  int ring_of_best = 0;
  for (int ring = 0; ring < kRings; ++ring)
    for (int i = 0; i < kDirections; ++i) {
      const double turn = 2 * kPi * i / kDirections;
      const Vec2 away(std::cos(turn), std::sin(turn));
      // The block's nearest side comes to this distance from the centre.
      const Vec2 middle = centre + (std::min(radius, 15.0) + 3 + kRing * ring) * away +
                          0.5 * size.cwiseProduct(away);
      const Box box{middle - size / 2, middle + size / 2};
      const double here = cost(box) + kPerRing * ring;
      if (here < least) least = here, best = box, ring_of_best = ring;
    }
  boxes_.push_back(best);
  std::string out;
  if (ring_of_best > 0) {
    const Vec2 end = centre.cwiseMax(best.low).cwiseMin(best.high);
    out += fmt::format(
        "    <path class=\"leader\" d=\"M {:.2f} {:.2f} L {:.2f} {:.2f}\" fill=\"none\" "
        "stroke=\"#808080\" stroke-width=\"0.25\" stroke-dasharray=\"1 1\"/>\n",
        centre.x(), centre.y(), end.x(), end.y());
  }
  double font = kLarge, y = best.low.y() + kLine;
  for (const std::string& line : lines) {
    out += rimmed_text({best.low.x(), y}, font, line, "start");
    y += kLine;
    font = kSmall;
  }
  return out;
}

}  // namespace loosefit::report
