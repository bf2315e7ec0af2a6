#include "loosefit/io/pieces/piece_folds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "loosefit/base/text.h"
#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/pattern/outline.h"

namespace loosefit::io {
namespace {

constexpr double kOneLine = 2e-3;        // apart from each other are marks of one fold [m]
constexpr double kRightAngle = 0.02;     // cosine of what still is one
constexpr double kArrowHead = 0.25;      // of the longest mark: shorter ones are heads of its arrow
constexpr std::size_t kMostNodes = 100;  // of a mark whose sides are tried
constexpr std::size_t kMostMarks = 100;  // of a piece
constexpr double kDrawnByHand = 5e-3;    // between a whole piece and its image [m]
constexpr double kSymmetric = 2e-3;      // between a hole and its image [m]

Vec2 across_of(const Axis& axis) {
  const Vec2 along = (axis.second - axis.first).normalized();
  return {-along.y(), along.x()};
}

double length_of(const Axis& axis) { return (axis.second - axis.first).norm(); }

Fold tried(const Outline& outline, const Axis& axis) {
  Outline copy = outline;
  std::vector<Outline> within;
  return unfold(copy, axis.first, axis.second, within);
}

bool on_one_line(const Axis& a, const Axis& b) {
  const Vec2 across = across_of(a);
  return std::abs(across.dot(b.first - a.first)) < kOneLine &&
         std::abs(across.dot(b.second - a.first)) < kOneLine;
}

struct Mark {
  Axis axis;
  bool on_outline = false;  ///< part of the outline lies on it
};

/// The lines of one mark.
std::vector<Mark> lines_of(const std::vector<Vec2>& mark, const Outline& outline) {
  std::vector<Axis> sides;
  const Axis chord(mark.front(), mark.back());
  if (length_of(chord) > kSamePoint) {
    if (tried(outline, chord) == Fold::unfolded) return {{chord, true}};
    sides.push_back(chord);
  }
  std::vector<Mark> found;
  Axis longest = chord;
  for (std::size_t i = 0; i + 1 < mark.size() && mark.size() <= kMostNodes; ++i) {
    const Axis side(mark[i], mark[i + 1]);
    if (length_of(side) <= kSamePoint) continue;
    if (tried(outline, side) == Fold::unfolded) found.push_back({side, true});
    if (length_of(side) > length_of(longest) || length_of(longest) <= kSamePoint) longest = side;
  }
  if (found.empty() && length_of(longest) > kSamePoint) found.push_back({longest, false});
  return found;
}

std::vector<Mark> fold_lines(const DrawnPiece& piece) {
  std::vector<Mark> all;
  double longest = 0;
  for (const std::vector<Vec2>& mark : piece.folds) {
    if (mark.size() < 2 || all.size() >= kMostMarks) continue;
    for (const Mark& line : lines_of(mark, piece.outline)) {
      longest = std::max(longest, length_of(line.axis));
      all.push_back(line);
    }
  }
  // Those on the outline come first, since one beside it may be a duplicate or the head of an
  // arrow.
  std::stable_sort(all.begin(), all.end(), [](const Mark& a, const Mark& b) {
    return std::pair(!a.on_outline, -length_of(a.axis)) <
           std::pair(!b.on_outline, -length_of(b.axis));
  });
  std::vector<Mark> lines;
  for (const Mark& line : all) {
    const bool known = std::any_of(lines.begin(), lines.end(), [&](const Mark& other) {
      return on_one_line(other.axis, line.axis);
    });
    const bool head = !line.on_outline && length_of(line.axis) < kArrowHead * longest;
    if (!known && !head) lines.push_back(line);
  }
  return lines;
}

bool is_symmetric(const std::vector<Vec2>& points, const Axis& axis, double within = kSymmetric) {
  const Vec2 across = across_of(axis);
  return std::all_of(points.begin(), points.end(), [&](const Vec2& p) {
    const Vec2 image = p - 2 * across.dot(p - axis.first) * across;
    return (pattern::closest_on_polygon(points, image) - image).norm() < within;
  });
}

std::vector<Vec2> points_of(const Outline& loop) {
  std::vector<Vec2> points;
  for (const OutlinePoint& p : loop) points.push_back(p.at);
  return points;
}

void unfold_holes(DrawnPiece& piece, const Axis& axis, std::vector<std::string>& notes) {
  const Vec2 across = across_of(axis);
  std::vector<pattern::PanelHole> unfolded;
  for (const pattern::PanelHole& hole : piece.holes) {
    double low = 1e9, high = -1e9;
    for (const Vec2& p : hole.points) {
      const double d = across.dot(p - axis.first);
      low = std::min(low, d), high = std::max(high, d);
    }
    if (low > kOnAxis || high < -kOnAxis) {
      pattern::PanelHole twin{hole.name + "_mirrored", hole.points};
      for (Vec2& p : twin.points) p -= 2 * across.dot(p - axis.first) * across;
      unfolded.push_back(hole);
      unfolded.push_back(std::move(twin));
    } else if (low < -kOnAxis && high > kOnAxis) {
      if (is_symmetric(hole.points, axis))
        unfolded.push_back(hole);
      else
        notes.push_back("its hole \"" + printable(hole.name) +
                        "\" is not cut: it crosses the fold and is not symmetric about it");
    } else {
      Outline loop;
      for (const Vec2& p : hole.points) loop.push_back({p});
      std::vector<Outline> within;
      if (unfold(loop, axis.first, axis.second, within) == Fold::unfolded && within.empty())
        unfolded.push_back({hole.name, points_of(loop)});
      else
        notes.push_back("its hole \"" + printable(hole.name) +
                        "\" is not cut: it touches the fold in a point");
    }
  }
  piece.holes = std::move(unfolded);
}

}  // namespace

Unfolded unfold_piece(DrawnPiece& piece) {
  Unfolded result;
  std::vector<Axis> used;
  for (const Mark& line : fold_lines(piece)) {
    const auto& [a, b] = line.axis;
    const Vec2 along = (b - a).normalized();
    const auto square = [&](const Axis& other) {
      return std::abs(along.dot((other.second - other.first).normalized())) < kRightAngle;
    };
    if (!used.empty() && (used.size() > 1 || !square(used[0]))) {
      result.notes.push_back(fmt::format(
          "it has {} fold lines, at {} of them it is unfolded: a further one is used at right "
          "angles to the first alone",
          piece.folds.size(), used.size()));
      break;
    }
    std::vector<Outline> within;
    switch (unfold(piece.outline, a, b, within)) {
      case Fold::unfolded: {
        piece.outline = cleaned(std::move(piece.outline));
        unfold_holes(piece, line.axis, result.notes);
        for (const Outline& loop : within) piece.holes.push_back({"inner hole", points_of(loop)});
        const Vec2 across = across_of(line.axis);
        for (std::size_t i = 0, n = piece.notches.size(); i < n; ++i)
          if (const double d = across.dot(piece.notches[i] - a); std::abs(d) > kOnAxis)
            piece.notches.push_back(piece.notches[i] - 2 * d * across);
        used.push_back(line.axis);
        break;
      }
      case Fold::whole:
        if (is_symmetric(points_of(piece.outline), line.axis, kDrawnByHand)) {
          result.notes.push_back("its mirror line runs through it: taken as a whole piece");
        } else {
          result.beside = true;
          result.notes.push_back(
              "its mirror line runs through it, and it is not symmetric about that: not unfolded");
        }
        break;
      case Fold::beside:
        result.beside = true;
        result.notes.push_back("no part of its outline lies on its mirror line: not unfolded");
        break;
    }
  }
  result.times = static_cast<int>(used.size());
  return result;
}

}  // namespace loosefit::io
