#include "loosefit/io/pieces/drawn_piece.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace loosefit::io {
namespace {

constexpr double kSideways = 22.5;  // of a grain, nearer to level than to the bias [degrees]

}  // namespace

void set_outline(DrawnPiece& piece, std::vector<Vec2> points, const std::vector<Vec2>& nodes) {
  if (points.size() < 3 || points.size() > kMostOutlinePoints) {
    piece.fault = fmt::format("its outline has {} points, 3 to {} are read", points.size(),
                              kMostOutlinePoints);
    return;
  }
  Chained chained = chain_lines({{std::move(points), true, false}}, nodes);
  if (!chained.loops.empty()) piece.outline = cleaned(std::move(chained.loops[0]));
}

void point_grains_up(const std::vector<DrawnPiece*>& pieces) {
  const auto along = [](const DrawnPiece& piece) -> Vec2 {
    return piece.grain->second - piece.grain->first;
  };
  const auto lies_sideways = [&](const DrawnPiece& piece) {
    const Vec2 grain = along(piece);
    return std::abs(grain.y()) < std::tan(radians(kSideways)) * std::abs(grain.x());
  };
  int to_the_right = 0;
  for (const DrawnPiece* piece : pieces)
    if (piece->grain && lies_sideways(*piece)) to_the_right += along(*piece).x() > 0 ? 1 : -1;
  for (DrawnPiece* piece : pieces) {
    if (!piece->grain) continue;
    const Vec2 grain = along(*piece);
    const bool down =
        lies_sideways(*piece) ? (grain.x() > 0) != (to_the_right >= 0) : grain.y() < 0;
    if (down) std::swap(piece->grain->first, piece->grain->second);
  }
}

}  // namespace loosefit::io
