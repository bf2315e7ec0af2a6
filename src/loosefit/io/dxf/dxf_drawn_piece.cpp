#include "loosefit/io/dxf/dxf_drawn_piece.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/io/pieces/piece_outline.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::io {
namespace {

constexpr std::size_t kMostLines = 2000;  // of one outline
constexpr double kSameCurve = 0.001;      // between two samplings of one curve [m]
constexpr double kShareOfPiece = 0.5;     // a sew line encloses at least so much of the piece
constexpr double kNarrowest = 0.002, kWidest = 0.06;  // seam allowance [m]
constexpr double kMm = 1000;

std::vector<Vec2> scaled(const DxfEntity& e, double metre) {
  std::vector<Vec2> points = e.points;
  for (Vec2& p : points) p *= metre;
  return points;
}

std::vector<DrawnLine> lines_on(const DxfBlock& block, int layer, double metre) {
  std::vector<DrawnLine> lines;
  for (const DxfEntity& e : block.entities)
    if (e.layer == layer && e.points.size() > 1)
      lines.push_back({scaled(e, metre), e.closed, e.kind == "POLYLINE" || e.kind == "LWPOLYLINE"});
  return lines;
}

std::vector<Vec2> points_on(const DxfBlock& block, int layer, double metre) {
  std::vector<Vec2> points;
  for (const DxfEntity& e : block.entities)
    if (e.layer == layer && e.kind == "POINT") points.push_back(metre * e.points[0]);
  return points;
}

std::vector<Vec2> polygon(const Outline& loop) {
  std::vector<Vec2> points;
  for (const OutlinePoint& p : loop) points.push_back(p.at);
  return points;
}

double perimeter(const Outline& loop) {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    length += (loop[(i + 1) % loop.size()].at - loop[i].at).norm();
  return length;
}

double distance_to(const std::vector<Vec2>& outline, const Vec2& p) {
  return (pattern::closest_on_polygon(outline, p) - p).norm();
}

bool lies_within(const Outline& inner, const Outline& outer) {
  const std::vector<Vec2> cut = polygon(outer);
  return std::all_of(inner.begin(), inner.end(), [&](const OutlinePoint& p) {
    return pattern::inside_polygon(cut, p.at) || distance_to(cut, p.at) < kChainGap;
  });
}

/// A closed line that follows the boundary at the distance of a seam allowance; at a fold it may
/// touch it.
bool follows_inside(const Outline& inner, const Outline& outer) {
  if (!lies_within(inner, outer)) return false;
  const std::vector<Vec2> cut = polygon(outer);
  std::size_t apart = 0;
  for (const OutlinePoint& p : inner) {
    const double d = distance_to(cut, p.at);
    if (d > kWidest) return false;
    apart += d > kNarrowest;
  }
  return 2 * apart > inner.size();
}

/// The same curve with more points: Gerber writes one on layer 84. (CLO writes control polygons
/// there, which are coarser.)
bool finer_copy(const Outline& fine, const Outline& coarse) {
  if (fine.size() <= coarse.size()) return false;
  const std::vector<Vec2> curve = polygon(fine);
  return std::abs(perimeter(fine) / perimeter(coarse) - 1) < 0.01 &&
         std::all_of(coarse.begin(), coarse.end(),
                     [&](const OutlinePoint& p) { return distance_to(curve, p.at) < kSameCurve; });
}

struct Layered {
  Outline outline;
  std::string fault;
  std::string unused;  ///< other lines of the layer; empty: none
};

bool near_any(const std::vector<Vec2>& points, const Vec2& p) {
  return std::any_of(points.begin(), points.end(),
                     [&](const Vec2& q) { return (p - q).norm() < kChainGap; });
}

/// Turn points stand on one layer for all lines of a piece. Where most of them are those of the
/// boundary, a line within it is cut at its kinks as well, as one without turn points is.
Chained chained_lines(const DxfBlock& block, int layer, double metre,
                      const std::vector<DrawnLine>& lines) {
  const std::vector<Vec2> all = points_on(block, 2, metre);
  if (layer == 1 || layer == 84) return chain_lines(lines, all);
  std::vector<Vec2> own;
  for (const Vec2& p : all)
    if (std::any_of(lines.begin(), lines.end(),
                    [&](const DrawnLine& line) { return near_any(line.points, p); }))
      own.push_back(p);
  if (2 * own.size() >= all.size()) return chain_lines(lines, own);
  Chained by_kinks = chain_lines(lines, {});
  if (own.empty()) return by_kinks;
  for (const Outline& loop : by_kinks.loops)
    for (const OutlinePoint& p : loop)
      if (p.corner) own.push_back(p.at);
  return chain_lines(lines, own);
}

/// Closed lines that go round what the outline goes round are the outline drawn again.
bool is_copy(const Outline& loop, const Outline& outline) {
  const std::vector<Vec2> around = polygon(outline);
  return std::all_of(
             loop.begin(), loop.end(),
             [&](const OutlinePoint& p) { return distance_to(around, p.at) < kChainGap; }) &&
         std::abs(perimeter(loop) / perimeter(outline) - 1) < 0.01;
}

Layered outline_on(const DxfBlock& block, int layer, double metre) {
  const std::vector<DrawnLine> lines = lines_on(block, layer, metre);
  if (lines.empty()) return {{}, fmt::format("nothing is drawn on layer {}", layer), {}};
  std::size_t points = 0;
  for (const DrawnLine& line : lines) points += line.points.size();
  if (lines.size() > kMostLines || points > kMostOutlinePoints)
    return {{},
            fmt::format("layer {} has {} lines with {} points, at most {} and {} are read", layer,
                        lines.size(), points, kMostLines, kMostOutlinePoints),
            {}};
  Chained chained = chained_lines(block, layer, metre, lines);
  Layered result;
  int closed = 0;
  for (Outline& loop : chained.loops) {
    Outline clean = cleaned(std::move(loop));
    if (clean.empty()) continue;
    if (result.outline.empty())
      result.outline = std::move(clean);
    else
      closed += !is_copy(clean, result.outline);
  }
  // What closes beside a larger line that stays open is a cutout or a mark, not the piece.
  if (result.outline.empty() || chained.open_area > outline_area(result.outline))
    return {
        {},
        fmt::format("its outline on layer {} is open by {:.2f} mm at ({:.6g}, {:.6g}), lines that "
                    "close within {:g} mm are expected",
                    layer, kMm * chained.gap, chained.gap_at.x() / metre,
                    chained.gap_at.y() / metre, kMm * kChainGap),
        {}};
  if (closed + chained.open > 0)
    result.unused = fmt::format(
        "layer {} has {} closed and {} open lines beside the largest one, which is its outline; "
        "they are not used",
        layer, closed, chained.open);
  return result;
}

Layered best_outline(const DxfBlock& block, double metre, DrawnPiece& result) {
  Layered cut = outline_on(block, 1, metre);
  Layered fine = outline_on(block, 84, metre);
  if (!fine.outline.empty() && (cut.outline.empty() || finer_copy(fine.outline, cut.outline)))
    cut = std::move(fine);
  if (cut.outline.empty()) return cut;
  if (!cut.unused.empty()) result.notes.push_back(cut.unused);
  const double enough = kShareOfPiece * outline_area(cut.outline);
  Layered sewn = outline_on(block, 14, metre);
  if (!lines_on(block, 14, metre).empty()) {
    if (!sewn.outline.empty() && outline_area(sewn.outline) >= enough &&
        lies_within(sewn.outline, cut.outline)) {
      result.on_sew_line = true;
      if (!sewn.unused.empty()) result.notes.push_back(sewn.unused);
      return sewn;
    }
    result.notes.push_back("its sew line (layer 14) is not taken, " +
                           (sewn.outline.empty() ? sewn.fault
                                                 : std::string("it does not lie within the "
                                                               "boundary")));
  }
  Layered inner = outline_on(block, 8, metre);
  if (!inner.outline.empty() && outline_area(inner.outline) >= enough &&
      follows_inside(inner.outline, cut.outline)) {
    result.on_sew_line = true;
    result.notes.push_back("the closed line on layer 8 along its boundary is taken as sew line");
    return inner;
  }
  return cut;
}

/// Where a notch lies along the outline: a point, a line from the outline inwards, or the two legs
/// of a V or the frame of a square, whose middle counts.
std::vector<Vec2> notch_points(const DxfBlock& block, double metre) {
  std::vector<Vec2> points;
  for (const DxfEntity& e : block.entities) {
    const bool text = e.kind == "TEXT" || e.kind == "MTEXT";
    if ((e.layer != 4 && (e.layer < 80 || e.layer > 83)) || e.points.empty() || text) continue;
    Vec2 at = e.points[0];
    if (e.closed) {
      at = Vec2::Zero();
      for (const Vec2& p : e.points) at += p / static_cast<double>(e.points.size());
    } else if (e.points.size() > 2) {
      at = (e.points.front() + e.points.back()) / 2;
    }
    points.push_back(metre * at);
  }
  return points;
}

/// Longest line on a layer: others may be the heads of its arrow.
std::optional<Axis> longest_axis(const DxfBlock& block, int layer, double metre) {
  std::optional<Axis> found;
  double longest = kSamePoint;
  for (const DxfEntity& e : block.entities)
    if (e.layer == layer && e.points.size() > 1) {
      const Axis axis(metre * e.points.front(), metre * e.points.back());
      const double length = (axis.second - axis.first).norm();
      if (length > longest) longest = length, found = axis;
    }
  return found;
}

}  // namespace

DrawnPiece drawn_piece(const DxfPiece& piece, double metre) {
  DrawnPiece result;
  const DxfBlock& block = *piece.block;
  result.name = piece.name;
  Layered best = best_outline(block, metre, result);
  result.outline = std::move(best.outline);
  result.fault = std::move(best.fault);
  result.notches = notch_points(block, metre);
  result.fold = longest_axis(block, 6, metre);
  result.grain = longest_axis(block, 7, metre);
  if (!result.grain)
    result.notes.push_back("it has no grain line (layer 7): the warp is taken along the file's y");
  return result;
}

}  // namespace loosefit::io
