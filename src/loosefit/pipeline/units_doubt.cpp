#include "loosefit/pipeline/units_doubt.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "loosefit/pattern/known_pieces.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::pipeline {
namespace {

constexpr double kLoosest = 2.2, kTightest = 0.6;        // garment over body
constexpr double kNobodyLarge = 5, kNobodySmall = 0.45;  // beyond them nothing can be worn
constexpr double kUsualEase = 1.1;                       // garment over body
constexpr double kLongest = 3, kShortest = 0.05;         // of a largest piece [m]
constexpr double kLongestStrip = 50;                     // [m]
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

struct Pieces {
  double largest = 0;              ///< [m]
  double largest_of_no_strip = 0;  ///< frills, ties and bindings may be of any length
};

Pieces pieces_of(const pattern::Pattern& pattern) {
  Pieces found;
  for (const pattern::Panel& panel : pattern.panels) {
    Eigen::AlignedBox2d box;
    for (const Vec2& q : pattern::outline_polygon(panel, 4)) box.extend(q);
    const double size = box.sizes().maxCoeff();
    found.largest = std::max(found.largest, size);
    if (!pattern::as_strip(pattern::outline_sections(panel)))
      found.largest_of_no_strip = std::max(found.largest_of_no_strip, size);
  }
  return found;
}

/// Whether the levels are those that the garment is worn at. A tube of which nothing says that it
/// is for the trunk may be a sleeve for an ankle or a cape: its upper edge is no waist.
bool are_worn_there(const pattern::Pattern& pattern, const std::vector<kinds::FitLevel>& levels) {
  const bool has_armholes_or_legs = std::ranges::any_of(levels, [](const kinds::FitLevel& level) {
    return level.name == "chest" || level.name == "thigh" || level.name == "knee";
  });
  return has_armholes_or_legs || std::ranges::any_of(pattern.panels, [](const auto& panel) {
           const pattern::PieceWords words = pattern::words_of(panel);
           return words.skirt || words.waist ||
                  std::ranges::count(panel.edges, "lower_interface", &pattern::PanelEdge::label);
         });
}

/// By how much elastics draw edges in [m].
double drawn_in(const pattern::Pattern& pattern) {
  double sum = 0;
  for (const pattern::Panel& panel : pattern.panels)
    for (std::size_t e = 0; e < panel.edges.size(); ++e)
      if (const auto& elastic = panel.edges[e].elastic)
        sum += std::max(0.0, 1 - elastic->ratio) *
               pattern::EdgePath(panel, static_cast<int>(e)).length();
  return sum;
}

}  // namespace

UnitsDoubt units_doubt(const pattern::Pattern& pattern,
                       const std::vector<kinds::FitLevel>& levels) {
  const Pieces pieces = pieces_of(pattern);
  const double piece =
      pieces.largest_of_no_strip > kLongest ? pieces.largest_of_no_strip : pieces.largest;
  if (pieces.largest_of_no_strip > kLongest || piece > kLongestStrip || piece < kShortest)
    return {fmt::format("a largest piece of {:.3g} m, which no garment has", piece),
            hint_of(piece / kUsualPiece), true};
  const auto at = std::ranges::find_if(
      levels, [](const kinds::FitLevel& level) { return level.body && *level.body > 0; });
  if (at == levels.end() || !are_worn_there(pattern, levels)) return {};
  double girth = at->garment;
  if (at->name == "waist" && girth > *at->body)
    girth = std::max(*at->body, girth - drawn_in(pattern));
  const double ratio = girth / *at->body;
  if (ratio <= kLoosest && ratio >= kTightest) return {};
  return {fmt::format("the garment measures {:.3g} m at the {}, the body {:.3g} m", girth, at->name,
                      *at->body),
          hint_of(ratio / kUsualEase), ratio > kNobodyLarge || ratio < kNobodySmall};
}

}  // namespace loosefit::pipeline
