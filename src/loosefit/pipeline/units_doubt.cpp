#include "loosefit/pipeline/units_doubt.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "loosefit/pattern/outline.h"

namespace loosefit::pipeline {
namespace {

constexpr double kLoosest = 2.2, kTightest = 0.5;        // garment over body
constexpr double kNobodyLarge = 5, kNobodySmall = 0.45;  // beyond them nothing can be worn
constexpr double kUsualEase = 1.1;                       // garment over body
constexpr double kLongest = 3, kShortest = 0.12;         // of a largest piece [m]
constexpr double kUsualPiece = 0.7;                      // [m]
constexpr double kFactors[] = {2.54, 10, 25.4, 100, 1000};

std::string hint_of(double ratio) {
  const bool large = ratio > 1;
  const double off = large ? ratio : 1 / ratio;
  const double factor = *std::ranges::min_element(
      kFactors, {}, [&](double f) { return std::abs(std::log(f / off)); });
  return fmt::format(
      "what it draws seems to be {} times too {}: check the units of the file (GarmentCode: "
      "properties.units_in_meter, how many of its units are a metre; DXF and SVG: units)",
      factor, large ? "large" : "small");
}

double largest_piece(const pattern::Pattern& pattern) {
  double largest = 0;
  for (const pattern::Panel& panel : pattern.panels) {
    Eigen::AlignedBox2d box;
    for (const Vec2& q : pattern::outline_polygon(panel, 4)) box.extend(q);
    largest = std::max(largest, box.sizes().maxCoeff());
  }
  return largest;
}

}  // namespace

UnitsDoubt units_doubt(const pattern::Pattern& pattern,
                       const std::vector<kinds::FitLevel>& levels) {
  const double piece = largest_piece(pattern);
  if (piece > kLongest || piece < kShortest)
    return {fmt::format("a largest piece of {:.3g} m, which no garment has", piece),
            hint_of(piece / kUsualPiece), true};
  const auto at = std::ranges::find_if(
      levels, [](const kinds::FitLevel& level) { return level.body && *level.body > 0; });
  if (at == levels.end()) return {};
  const double ratio = at->garment / *at->body;
  if (ratio <= kLoosest && ratio >= kTightest) return {};
  return {fmt::format("the garment measures {:.3g} m at the {}, the body {:.3g} m", at->garment,
                      at->name, *at->body),
          hint_of(ratio / kUsualEase), ratio > kNobodyLarge || ratio < kNobodySmall};
}

}  // namespace loosefit::pipeline
