#include "loosefit/io/dxf/dxf_drawn_piece.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "loosefit/base/text.h"
#include "loosefit/io/pieces/fold_words.h"
#include "loosefit/io/pieces/piece_outline.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::io {
namespace {

constexpr std::size_t kMostLines = 2000;              // of one outline
constexpr double kSameCurve = 0.001;                  // between two samplings of one curve [m]
constexpr double kNarrowest = 0.002, kWidest = 0.06;  // seam allowance [m]
constexpr double kMm = 1000;
constexpr std::size_t kMostOfArrow = 20;  // corners of an arrow that is drawn as a closed line

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
  std::vector<Outline> inside, beside;  ///< other closed lines of the layer
  int open = 0;                         ///< lines of the layer that do not close
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
  if (lines.empty()) return {{}, fmt::format("nothing is drawn on layer {}", layer), {}, {}, 0};
  std::size_t points = 0;
  for (const DrawnLine& line : lines) points += line.points.size();
  if (lines.size() > kMostLines || points > kMostOutlinePoints)
    return {{},
            fmt::format("layer {} has {} lines with {} points, at most {} and {} are read", layer,
                        lines.size(), points, kMostLines, kMostOutlinePoints),
            {},
            {},
            0};
  Chained chained = chained_lines(block, layer, metre, lines);
  Layered result;
  for (Outline& loop : chained.loops) {
    Outline clean = cleaned(std::move(loop));
    if (clean.empty()) continue;
    if (result.outline.empty())
      result.outline = std::move(clean);
    else if (!is_copy(clean, result.outline))
      (lies_within(clean, result.outline) ? result.inside : result.beside)
          .push_back(std::move(clean));
  }
  // What closes beside a larger line that stays open is a cutout or a mark, not the piece.
  if (result.outline.empty() || chained.open_area > outline_area(result.outline))
    return {
        {},
        fmt::format("its outline on layer {} is open by {:.2f} mm at ({:.6g}, {:.6g}), lines that "
                    "close within {:g} mm are expected",
                    layer, kMm * chained.gap, chained.gap_at.x() / metre,
                    chained.gap_at.y() / metre, kMm * kChainGap),
        {},
        {},
        0};
  result.open = chained.open;
  return result;
}

/// The closed lines of a layer, whatever stays open on it.
std::vector<Outline> loops_on(const DxfBlock& block, int layer, double metre, int& open) {
  const std::vector<DrawnLine> lines = lines_on(block, layer, metre);
  open = 0;
  if (lines.size() > kMostLines) return {};
  Chained chained = chain_lines(lines, {});
  open = chained.open;
  std::vector<Outline> loops;
  for (Outline& loop : chained.loops)
    if (Outline clean = cleaned(std::move(loop)); !clean.empty()) loops.push_back(std::move(clean));
  return loops;
}

std::string square_centimetres(const Outline& loop) {
  return fmt::format("{:.0f} cm2", 1e4 * std::abs(outline_area(loop)));
}

/// The outlines of a block, each with the closed lines of its layer that lie in it.
struct Found {
  Outline outline;
  std::vector<Outline> inside;
  bool on_sew_line = false;
};

/// The sew line within a boundary, of those on layer 14; the boundary without one.
Found sewn_or_cut(Outline cut, std::vector<Outline> inside, std::vector<Outline>& sewn) {
  const double enough = kShareOfPiece * outline_area(cut);
  const auto seam = std::find_if(sewn.begin(), sewn.end(), [&](const Outline& loop) {
    return outline_area(loop) >= enough && lies_within(loop, cut);
  });
  Found found{std::move(cut), std::move(inside), seam != sewn.end()};
  if (!found.on_sew_line) return found;
  const Outline boundary = std::exchange(found.outline, std::move(*seam));
  sewn.erase(seam);
  // The sew line of a hole lies round the hole.
  std::vector<Outline> holes;
  for (Outline& loop : sewn)
    if (lies_within(loop, found.outline)) holes.push_back(loop);
  std::erase_if(sewn, [&](const Outline& loop) { return lies_within(loop, boundary); });
  for (Outline& loop : found.inside)
    if (std::none_of(holes.begin(), holes.end(),
                     [&](const Outline& hole) { return lies_within(loop, hole); }))
      holes.push_back(std::move(loop));
  found.inside = std::move(holes);
  return found;
}

/// No part of it in the outline of the layer or in another closed line there.
bool lies_beside(const Outline& loop, const Layered& cut) {
  const auto apart = [&](const Outline& other) {
    const std::vector<Vec2> around = polygon(other);
    return std::none_of(loop.begin(), loop.end(), [&](const OutlinePoint& p) {
      return pattern::inside_polygon(around, p.at) || distance_to(around, p.at) < kSameCurve;
    });
  };
  return apart(cut.outline) && std::all_of(cut.beside.begin(), cut.beside.end(), apart);
}

double farthest_inside(const Outline& inner, const std::vector<Vec2>& boundary) {
  double far = 0;
  for (const OutlinePoint& p : inner) far = std::max(far, distance_to(boundary, p.at));
  return far;
}

/// The largest outline first; without any, `fault` says why.
std::vector<Found> outlines_of(const DxfBlock& block, double metre, std::string& fault,
                               std::vector<std::string>& notes) {
  Layered cut = outline_on(block, 1, metre);
  Layered fine = outline_on(block, 84, metre);
  if (!cut.outline.empty())
    for (const std::vector<Outline>& loops : {std::vector<Outline>{fine.outline}, fine.beside})
      for (const Outline& loop : loops)
        if (!loop.empty() && outline_area(loop) >= kSmallestPiece && lies_beside(loop, cut))
          notes.push_back("a closed line of " + square_centimetres(loop) +
                          " on layer 84 beside its outline is not used");
  if (!fine.outline.empty() && (cut.outline.empty() || finer_copy(fine.outline, cut.outline)))
    cut.outline = std::move(fine.outline), cut.fault.clear();
  if (cut.outline.empty()) {
    fault = cut.fault;
    return {};
  }
  if (cut.open > 0)
    notes.push_back(
        fmt::format("{} open lines on layer 1 beside its outline are not used", cut.open));
  Layered sewn = outline_on(block, 14, metre);
  std::vector<Outline> seams;
  if (!sewn.outline.empty()) {
    seams.push_back(std::move(sewn.outline));
    for (std::vector<Outline>* more : {&sewn.inside, &sewn.beside})
      for (Outline& loop : *more) seams.push_back(std::move(loop));
    if (sewn.open > 0)
      notes.push_back(
          fmt::format("{} open lines on layer 14 beside its sew line are not used", sewn.open));
  }
  const std::vector<Vec2> boundary = polygon(cut.outline);
  std::vector<Found> found{sewn_or_cut(std::move(cut.outline), std::move(cut.inside), seams)};
  if (!found[0].on_sew_line && !lines_on(block, 14, metre).empty())
    notes.push_back("its sew line (layer 14) is not taken, " +
                    (seams.empty() ? sewn.fault
                     : lies_within(seams[0], found[0].outline)
                         ? "the closed line of " + square_centimetres(seams[0]) +
                               " there is less than half of the boundary: a mark?"
                         : std::string("it does not lie within the boundary")));
  if (found[0].on_sew_line)
    if (const double far = farthest_inside(found[0].outline, boundary); far > kWidest)
      notes.push_back(fmt::format(
          "its sew line (layer 14) lies up to {:.0f} mm within its boundary, more than an "
          "allowance: taken all the same",
          kMm * far));
  if (!found[0].on_sew_line) {
    Layered inner = outline_on(block, 8, metre);
    if (!inner.outline.empty() &&
        outline_area(inner.outline) >= kShareOfPiece * outline_area(found[0].outline) &&
        follows_inside(inner.outline, found[0].outline)) {
      found[0].outline = std::move(inner.outline);
      found[0].on_sew_line = true;
      notes.push_back("the closed line on layer 8 along its boundary is taken as sew line");
    }
  }
  // Closed lines of the boundary's layer beside it, which may lie in each other.
  for (Outline& loop : cut.beside) {
    const auto round = std::find_if(found.begin() + 1, found.end(), [&](const Found& other) {
      return lies_within(loop, other.outline);
    });
    if (round != found.end())
      round->inside.push_back(std::move(loop));
    else if (outline_area(loop) >= kSmallestPiece)
      found.push_back(sewn_or_cut(std::move(loop), {}, seams));
    else
      notes.push_back(
          "a closed line on layer 1 beside its outline is not used, it has less than "
          "4 cm2");
  }
  return found;
}

/// The hole that a text in it names.
std::string hole_name(const DxfBlock& block, const Outline& loop, double metre) {
  const std::vector<Vec2> rim = polygon(loop);
  for (const DxfEntity& e : block.entities)
    if ((e.kind == "TEXT" || e.kind == "MTEXT") && !e.points.empty() &&
        pattern::words_of(e.text).hole && pattern::inside_polygon(rim, metre * e.points[0]))
      return e.text;
  return {};
}

/// Cutouts: closed lines on layer 11, those within the boundary on its own layer, and what a text
/// calls a hole on layer 8. Others on layer 8 are drawn on the cloth.
void find_holes(const DxfBlock& block, const Found& found, double metre, DrawnPiece& piece,
                std::vector<bool>& taken) {
  const auto cut = [&](const Outline& loop, const std::string& called) {
    const std::string text = hole_name(block, loop, metre);
    piece.holes.push_back({text.empty() ? called : text, polygon(loop)});
  };
  for (const Outline& loop : found.inside)
    if (outline_area(loop) <= kShareOfPiece * outline_area(found.outline))
      cut(loop, "cutout");
    else
      piece.notes.push_back("a closed line of " + square_centimetres(loop) +
                            " within its outline is not cut, it is nearly as large: another size?");
  int open = 0;
  std::vector<Outline> cutouts = loops_on(block, 11, metre, open);
  taken.resize(cutouts.size(), false);
  for (std::size_t k = 0; k < cutouts.size(); ++k) {
    const std::vector<Vec2> around = polygon(found.outline);
    const bool here = std::any_of(cutouts[k].begin(), cutouts[k].end(), [&](const OutlinePoint& p) {
      return pattern::inside_polygon(around, p.at) || distance_to(around, p.at) < kChainGap;
    });
    if (here && !taken[k]) cut(cutouts[k], "cutout"), taken[k] = true;
  }
  if (open > 0 && piece.holes.empty())
    piece.notes.push_back(
        fmt::format("{} cutouts on layer 11 are not cut, they do not close", open));
  std::vector<std::string> drawn;
  for (const Outline& loop : loops_on(block, 8, metre, open)) {
    if (std::abs(outline_area(loop)) < kSmallestPiece || !lies_within(loop, found.outline) ||
        is_copy(loop, found.outline))
      continue;
    if (const std::string text = hole_name(block, loop, metre); !text.empty())
      cut(loop, text);
    else
      drawn.push_back(square_centimetres(loop));
  }
  if (!drawn.empty())
    piece.notes.push_back(fmt::format(
        "{} closed lines on layer 8 (internal lines), the largest of {}, are drawn on it and not "
        "cut; cutouts stand on layer 11",
        drawn.size(), drawn.front()));
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

/// Lines of a layer that have a direction. Of arrows that are drawn as closed lines it is that of
/// their longest side; circles and other closed curves have none.
std::vector<std::vector<Vec2>> marks_on(const DxfBlock& block, int layer, double metre,
                                        int* without = nullptr) {
  std::vector<std::vector<Vec2>> marks;
  for (const DxfEntity& e : block.entities) {
    if (e.layer != layer || e.points.size() < 2) continue;
    std::vector<Vec2> points = scaled(e, metre);
    const bool curve = e.kind == "CIRCLE" || e.kind == "ELLIPSE" || e.kind == "ARC" ||
                       (e.closed && points.size() > kMostOfArrow);
    if (curve) {
      if (without) ++*without;
    } else if (e.closed && points.size() > 2) {
      std::size_t longest = 0;
      const auto side = [&](std::size_t k) -> Vec2 {
        return points[(k + 1) % points.size()] - points[k];
      };
      for (std::size_t k = 1; k < points.size(); ++k)
        if (side(k).norm() > side(longest).norm()) longest = k;
      marks.push_back({points[longest], points[(longest + 1) % points.size()]});
    } else {
      marks.push_back(std::move(points));
    }
  }
  return marks;
}

/// Index of the outline in which a point lies, or that is nearest.
std::size_t outline_at(const std::vector<std::vector<Vec2>>& outlines, const Vec2& p) {
  std::size_t best = 0;
  double least = 1e300;
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    const double d = pattern::inside_polygon(outlines[k], p) ? 0 : distance_to(outlines[k], p);
    if (d < least) least = d, best = k;
  }
  return best;
}

}  // namespace

std::vector<DrawnPiece> pieces_of_block(const DxfPiece& piece, double metre) {
  const DxfBlock& block = *piece.block;
  std::string fault;
  std::vector<std::string> notes;
  std::vector<Found> found = outlines_of(block, metre, fault, notes);
  const bool none = found.empty();
  if (none) found.emplace_back();
  std::vector<std::vector<Vec2>> around;
  for (const Found& one : found) around.push_back(polygon(one.outline));
  const auto belongs = [&](std::size_t k, const Vec2& p) {
    return none || outline_at(around, p) == k;
  };
  std::vector<DrawnPiece> pieces;
  std::vector<bool> taken;
  for (std::size_t k = 0; k < found.size(); ++k) {
    DrawnPiece one;
    one.name = piece.name;
    one.fault = fault;
    one.on_sew_line = found[k].on_sew_line;
    if (k == 0)
      one.notes = notes;
    else
      one.notes.push_back("a further outline of its block, of " +
                          square_centimetres(found[k].outline) +
                          ", is taken as a piece of its own");
    if (!none) find_holes(block, found[k], metre, one, taken);
    for (const Vec2& p : notch_points(block, metre))
      if (belongs(k, p)) one.notches.push_back(p);
    int round = 0;
    for (std::vector<Vec2>& mark : marks_on(block, 6, metre, &round))
      if (belongs(k, (mark.front() + mark.back()) / 2)) one.folds.push_back(std::move(mark));
    // The longest line: others may be the heads of its arrow.
    double longest = kSamePoint;
    for (const std::vector<Vec2>& mark : marks_on(block, 7, metre, &round))
      if (const double length = (mark.back() - mark.front()).norm();
          length > longest && belongs(k, (mark.front() + mark.back()) / 2))
        longest = length, one.grain = Axis(mark.front(), mark.back());
    if (round > 0 && k == 0)
      one.notes.push_back(fmt::format(
          "{} circles or closed curves on layers 6 and 7 are no mirror line and no grain line: not "
          "used",
          round));
    if (!one.grain)
      one.notes.push_back("it has no grain line (layer 7): the warp is taken along the file's y");
    std::vector<std::string> texts = piece.texts;
    texts.insert(texts.end(), {piece.annotation, piece.quantity});
    if (one.folds.empty())
      for (const std::string& text : texts)
        note_missing_fold(one, "its text", text, "no mirror line (layer 6)");
    one.outline = std::move(found[k].outline);
    pieces.push_back(std::move(one));
  }
  const auto lost = std::count(taken.begin(), taken.end(), false);
  if (lost > 0 && !none)
    pieces[0].notes.push_back(
        fmt::format("{} closed lines on layer 11 (cutouts) lie in no outline: not cut", lost));
  return pieces;
}

}  // namespace loosefit::io
