#include "loosefit/io/pieces/freesewing_piece.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <utility>

#include "loosefit/base/text.h"
#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/io/pieces/fold_words.h"
#include "loosefit/pattern/outline.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::io {
namespace {

constexpr double kShareOfFold = 0.25;  // of a half piece's length that lies on its fold

double distance(const std::vector<Vec2>& outline, const Vec2& p) {
  return (pattern::closest_on_polygon(outline, p) - p).norm();
}

/// Most of the piece lies on one side of the line and a good part of its outline on it.
bool begins_at(const std::vector<Vec2>& points, const Axis& middle) {
  const Vec2 along = (middle.second - middle.first).normalized();
  double low = 1e9, high = -1e9, on = 0, first = 1e9, last = -1e9;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 a = points[i] - middle.first, b = points[(i + 1) % points.size()] - middle.first;
    const double da = geometry::cross(along, a), db = geometry::cross(along, b);
    low = std::min(low, da), high = std::max(high, da);
    first = std::min(first, a.dot(along)), last = std::max(last, a.dot(along));
    if (std::abs(da) < kOnAxis && std::abs(db) < kOnAxis) on += (b - a).norm();
  }
  return (low > -kOnAxis || high < kOnAxis) && on > kShareOfFold * (last - first);
}

/// Designs of FreeSewing are named in English: frontLeft and frontRight, leftSleeve and
/// rightSleeve.
bool other_hand_stands_in(const std::set<std::string>& parts, const std::string& name) {
  const auto lower = [](std::string s) {
    std::transform(s.begin(), s.end(), s.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return s;
  };
  std::string other = lower(name);
  if (const std::size_t left = other.find("left"); left != std::string::npos)
    other.replace(left, 4, "right");
  else if (const std::size_t right = other.find("right"); right != std::string::npos)
    other.replace(right, 5, "left");
  else
    return false;
  return std::any_of(parts.begin(), parts.end(),
                     [&](const std::string& part) { return lower(part) == other; });
}

std::string called(const FreesewingLine& line) {
  return (line.name.empty() ? "line " : "line \"" + printable(line.name) + "\" ") + line.place;
}

/// Halves may be drawn open at the fold, where nothing is sewn.
std::vector<Vec2> around(const FreesewingLine& line) {
  std::vector<Vec2> points = line.line.points;
  if (points.size() > 2 && (points.front() - points.back()).norm() < kChainGap) points.pop_back();
  return points;
}

/// Between the ends of an open line; 0: closed, or both lie on a fold.
double gap_off_folds(const DrawnLine& line, const std::vector<std::vector<Vec2>>& folds,
                     const Axis& middle) {
  if (line.closed || line.points.size() < 3) return 0;
  const Vec2 first = line.points.front(), last = line.points.back();
  const double gap = (last - first).norm();
  const auto on = [&](const Vec2& a, const Vec2& b) {
    if ((b - a).norm() < kChainGap) return false;
    const Vec2 along = (b - a).normalized();
    return std::abs(geometry::cross(along, first - a)) < kOnAxis &&
           std::abs(geometry::cross(along, last - a)) < kOnAxis;
  };
  const bool at_fold = on(middle.first, middle.second) ||
                       std::any_of(folds.begin(), folds.end(),
                                   [&](const auto& f) { return on(f.front(), f.back()); });
  return gap < kChainGap || at_fold ? 0 : gap;
}

bool is_closed(const FreesewingLine& line) {
  return line.line.closed ||
         (line.line.points.size() > 3 &&
          (line.line.points.front() - line.line.points.back()).norm() < kChainGap);
}

double area_of(const FreesewingLine& line) {
  return std::abs(pattern::signed_area(line.line.points));
}

bool may_be_outline(const FreesewingLine& line) { return line.line.points.size() > 2; }

/// How often the texts say that it is cut, if they do.
std::optional<PieceCount> count_in(const std::vector<std::string>& texts,
                                   std::vector<std::string>& notes) {
  std::optional<PieceCount> count;
  for (const std::string& text : texts) {
    const std::optional<PieceCount> one = find_quantity(text);
    if (!one && speaks_of_count(text))
      notes.push_back("its text \"" + printable(text, 60) +
                      "\" may say how often it is cut and is not understood: it counts nothing");
    if (!one) continue;
    if (!count)
      count = one;
    else if (one->as_drawn != count->as_drawn || one->mirrored != count->mirrored)
      notes.push_back("its texts say \"" + printable(count->said, 60) + "\" and \"" +
                      printable(one->said, 60) + "\": the first is taken");
  }
  return count;
}

/// Closed lines of linings, canvas and other cloths, which stand for pieces where they lie on none.
bool tell_others(const FreesewingPart& part, const std::vector<std::vector<Vec2>>& outer,
                 LeftOut& left) {
  bool told = false;
  for (const FreesewingOther& other : part.others) {
    if (std::abs(pattern::signed_area(other.points)) < kSmallestPiece) continue;
    const bool on_a_piece = std::any_of(outer.begin(), outer.end(), [&](const auto& outline) {
      return std::all_of(other.points.begin(), other.points.end(), [&](const Vec2& p) {
        return pattern::inside_polygon(outline, p) || distance(outline, p) < kChainGap;
      });
    });
    if (on_a_piece) continue;
    left.tell("part " + printable(part.name) + ": its closed line " + other.place +
              " is left out, it is of class \"" + printable(other.classes, 60) +
              "\" and not of \"fabric\"");
    told = true;
  }
  return told;
}

}  // namespace

bool FreesewingPart::has_outline() const {
  return std::any_of(lines.begin(), lines.end(), may_be_outline);
}

std::vector<CountedPiece> drawn_freesewing(const FreesewingPart& part, bool marked,
                                           const std::set<std::string>& parts, LeftOut& left) {
  const std::string in_part = "part " + printable(part.name) + ": ";
  // The largest line first; those of fabric before all others.
  std::vector<const FreesewingLine*> lines;
  for (const FreesewingLine& line : part.lines)
    if (may_be_outline(line)) lines.push_back(&line);
  std::stable_sort(lines.begin(), lines.end(), [](const auto* a, const auto* b) {
    return std::pair(!a->fabric, -area_of(*a)) < std::pair(!b->fabric, -area_of(*b));
  });
  if (lines.empty()) {
    if (!tell_others(part, {}, left))
      left.unused.push_back("part " + printable(part.name) +
                            ": it has no closed path of class \"fabric\"");
    return {};
  }

  std::vector<const FreesewingLine*> outlines;  // of its pieces
  std::vector<std::vector<Vec2>> outer;
  std::vector<std::vector<pattern::PanelHole>> holes;
  for (const FreesewingLine* line : lines) {
    const std::vector<Vec2> points = around(*line);
    if (outlines.empty()) {
      outlines.push_back(line), outer.push_back(points), holes.emplace_back();
      continue;
    }
    if (!line->fabric || !is_closed(*line)) {
      // A line that is open and encloses little is a dart, a pleat or a placket.
      if (is_closed(*line) && area_of(*line) >= kSmallestPiece)
        left.tell(in_part + "closed " + called(*line) + " is not used, it has no class \"fabric\"");
      else
        left.unused.push_back(in_part + called(*line) + " is not used, it is " +
                              (is_closed(*line) ? "small" : "open"));
      continue;
    }
    if (area_of(*line) < kSmallestPiece) {
      left.tell(in_part + "closed " + called(*line) + " is not used, it has less than 4 cm2");
      continue;
    }
    bool crosses = false;
    std::size_t within = outer.size();
    for (std::size_t k = 0; k < outer.size(); ++k) {
      const auto inside = std::count_if(points.begin(), points.end(), [&](const Vec2& p) {
        return pattern::inside_polygon(outer[k], p) || distance(outer[k], p) < kChainGap;
      });
      if (inside == static_cast<std::ptrdiff_t>(points.size()))
        within = k;
      else
        crosses |= std::any_of(points.begin(), points.end(), [&](const Vec2& p) {
          return pattern::inside_polygon(outer[k], p) && distance(outer[k], p) > kChainGap;
        });
    }
    if (within < outer.size() && pattern::words_of(line->name).pocket)
      left.tell(in_part + "closed " + called(*line) +
                " is drawn on it and not cut, it is called after a facing, a lining or a pocket");
    else if (within < outer.size())
      holes[within].push_back({line->name.empty() ? "hole" : line->name, points});
    else if (crosses)
      left.tell(in_part + "closed " + called(*line) + " is not used, it crosses the outline");
    else
      outlines.push_back(line), outer.push_back(points), holes.emplace_back();
  }

  const bool one_hand = other_hand_stands_in(parts, part.name);
  const std::size_t dot = part.name.rfind('.');
  tell_others(part, outer, left);
  std::vector<CountedPiece> pieces;
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    CountedPiece one;
    DrawnPiece& piece = one.piece;
    one.place = outlines[k]->place;
    piece.name = dot == std::string::npos ? part.name : part.name.substr(dot + 1);
    const pattern::PieceWords words = pattern::words_of(piece.name);
    piece.grain = part.grain;
    piece.on_sew_line = true;
    piece.holes = std::move(holes[k]);
    const auto nearest = [&](const Vec2& p) {
      std::size_t best = 0;
      for (std::size_t i = 1; i < outer.size(); ++i)
        if (distance(outer[i], p) < distance(outer[best], p)) best = i;
      return best;
    };
    std::copy_if(part.notches.begin(), part.notches.end(), std::back_inserter(piece.notches),
                 [&](const Vec2& p) { return nearest(p) == k; });
    for (const std::vector<Vec2>& fold : part.folds)
      if (nearest((fold.front() + fold.back()) / 2) == k) piece.folds.push_back(fold);
    if (piece.folds.empty() && !marked && !one_hand && (words.front || words.back) &&
        begins_at(outer[k], part.middle))
      piece.folds.push_back({part.middle.first, part.middle.second});
    if (const auto said = count_in(part.texts, piece.notes))
      one.count = *said;
    else if (k == 0 && piece.folds.empty() && !one_hand &&
             (words.sleeve || words.cuff || words.leg || words.front || words.back ||
              (words.hood && !words.centre)))
      one.count.mirrored = 1;
    if (const double gap = gap_off_folds(outlines[k]->line, piece.folds, part.middle); gap > 0)
      piece.notes.push_back(
          fmt::format("its outline is open: its ends are {:.3g} mm apart; a "
                      "straight line closes it",
                      1e3 * gap));
    if (k > 0)
      piece.notes.push_back("a further outline of its part, " + called(*outlines[k]) +
                            ", is taken as a piece of its own");
    if (piece.folds.empty())
      for (const std::string& text : part.texts)
        note_missing_fold(piece, "its text", text, "no mark");
    set_outline(piece, outer[k], outlines[k]->nodes);
    pieces.push_back(std::move(one));
  }
  return pieces;
}

}  // namespace loosefit::io
