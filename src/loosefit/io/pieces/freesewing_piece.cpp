#include "loosefit/io/pieces/freesewing_piece.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::io {
namespace {

constexpr double kShareOfFold = 0.25;  // of a half piece's length that lies on its fold

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

}  // namespace

DrawnPiece drawn_freesewing(FreesewingPart part, bool marked, const std::set<std::string>& parts,
                            PieceCount& count) {
  DrawnPiece piece;
  const bool one_hand = other_hand_stands_in(parts, part.name);
  const std::size_t dot = part.name.rfind('.');
  piece.name = dot == std::string::npos ? part.name : part.name.substr(dot + 1);
  const pattern::PieceWords words = pattern::words_of(piece.name);
  piece.notches = std::move(part.notches);
  piece.grain = part.grain;
  piece.fold = part.fold;
  piece.on_sew_line = true;
  // Halves may be drawn open at the fold, where nothing is sewn.
  std::vector<Vec2>& points = part.seam.points;
  if (points.size() > 2 && (points.front() - points.back()).norm() < kChainGap) points.pop_back();
  if (!piece.fold && !marked && !one_hand && (words.front || words.back) &&
      begins_at(points, part.middle))
    piece.fold = part.middle;
  count = {};
  if (!piece.fold && !one_hand &&
      (words.sleeve || words.cuff || words.leg || words.front || words.back ||
       (words.hood && !words.centre)))
    count.mirrored = 1;
  set_outline(piece, std::move(points), part.nodes);
  return piece;
}

}  // namespace loosefit::io
