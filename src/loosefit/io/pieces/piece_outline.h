#pragma once
#include <optional>
#include <string>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::io {

/// A drawn line of a piece's outline [m].
struct DrawnLine {
  std::vector<Vec2> points;
  bool closed = false;   ///< the last point joins the first, which is not repeated
  bool one_edge = true;  ///< its ends are corners; otherwise only where the outline has a kink
};

/// One point of a closed outline.
struct OutlinePoint {
  Vec2 at;              ///< [m]
  bool corner = false;  ///< an edge begins here
};
using Outline = std::vector<OutlinePoint>;

/// Lengths below which things are the same [m]. DXF pattern files round to 0.01 mm or 0.0001 in.
inline constexpr double kSamePoint = 1e-5, kChainGap = 1e-4, kOnAxis = 5e-4;

/// Closed lines that enclose less are letters and marks, not cloth [m²].
inline constexpr double kSmallestPiece = 4e-4;
/// Of a cut line, what its sew line and the lines of its next sizes enclose at least.
inline constexpr double kShareOfPiece = 0.5;

/// Points of one outline; more make checks of it slow.
inline constexpr std::size_t kMostOutlinePoints = 5000;

/// What lines make together.
struct Chained {
  std::vector<Outline> loops;  ///< the largest by area first
  int open = 0;                ///< how many chains stay open
  double open_area = 0;        ///< of the largest of them, closed by a straight line [m²]
  double gap = 0;              ///< between its ends [m]
  Vec2 gap_at = Vec2::Zero();  ///< one of these ends
};

/// Joins lines end to end, in their order where that leads on, else by the nearest end within
/// kChainGap. Corners of closed lines, and between lines that are not one edge each, are kinks:
/// turns above 20 degrees at one of `turn_points`, above 40 degrees where there are none. (Real
/// corners turn by more than 60, those of sampled curves that are marked as corners by less than 19
/// degrees in a garment of CLO.)
Chained chain_lines(const std::vector<DrawnLine>& lines, const std::vector<Vec2>& turn_points);

/// Without repeated points and without ways that lead out and straight back, which some programs
/// leave in outlines; counter-clockwise; at least two corners, set where a loop has fewer.
/// Empty when nothing is left.
Outline cleaned(Outline loop);

/// Signed area [m²], counter-clockwise positive.
double outline_area(const Outline& loop);

/// How a piece lies to its mirror line.
enum class Fold { unfolded, whole, beside };

/// Unfolds a half piece: the parts of the outline along the axis from a to b go, the rest is
/// mirrored and joined; edges that meet at the fold without a kink become one. Where the outline
/// leaves the axis between two such parts, a hole closes, which goes to `holes`. `whole`: the
/// outline lies on both sides, the line is one of symmetry; `beside`: no part of the outline lies
/// on it.
Fold unfold(Outline& loop, const Vec2& a, const Vec2& b, std::vector<Outline>& holes);

}  // namespace loosefit::io
