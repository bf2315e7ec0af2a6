#include "loosefit/pattern/known_one_shoulder.h"

#include <algorithm>
#include <cmath>

#include "loosefit/geometry/flat_triangle.h"

namespace loosefit::pattern {
namespace {

constexpr double kConcave = -0.01;      // bulge of an armhole, at most
constexpr double kLongerSlant = 1.2;    // than the armhole
constexpr double kFlatterSlant = 0.6;   // way along the hem over the way up, at least
constexpr double kWiderThanTip = 2;     // of a hem, over the shoulder
constexpr double kShortestSide = 0.05;  // [m]
constexpr double kUnlikeSides = 0.2;    // of the longer one: both end at an underarm

/// A section by what it is on a piece whose armhole comes next to its first side.
std::vector<Stitch::Side> sides(const Pattern& pattern, int panel, const KnownPiece& piece,
                                int section) {
  const int at = piece.side > 0 ? section : (6 - section) % 6;
  return piece.sections[at].sides(pattern.panels[panel], panel);
}

}  // namespace

std::optional<KnownPiece> as_one_shoulder(const std::vector<Section>& sections) {
  if (sections.size() != 6) return {};
  const auto shortest = std::ranges::min_element(sections, {}, &Section::length);
  KnownPiece piece;
  piece.sections = sections;
  std::ranges::rotate(piece.sections,
                      piece.sections.begin() + ((shortest - sections.begin()) + 3) % 6);
  const auto& s = piece.sections;
  piece.side = s[2].length < s[4].length ? 1 : -1;
  const Section &armhole = piece.side > 0 ? s[2] : s[4], &slant = piece.side > 0 ? s[4] : s[2];
  const Vec2 along = (s[0].to - s[0].from).normalized(), way = slant.to - slant.from;
  if (armhole.bulge > kConcave || slant.length < kLongerSlant * armhole.length ||
      std::abs(way.dot(along)) < kFlatterSlant * std::abs(geometry::cross(along, way)) ||
      s[0].chord() < kWiderThanTip * s[3].chord() ||
      std::min(s[1].length, s[5].length) < kShortestSide ||
      std::abs(s[1].length - s[5].length) > kUnlikeSides * std::max(s[1].length, s[5].length))
    return {};
  piece.upright = (s[3].from + s[3].to).y() > (s[0].from + s[0].to).y();
  return piece;
}

std::vector<ChainSeam> one_shoulder_seams(const Pattern& pattern, int front,
                                          const KnownPiece& of_front, int back,
                                          const KnownPiece& of_back) {
  const bool left = of_front.side > 0;
  const auto seam = [&](const char* name, int section) {
    return ChainSeam{name, sides(pattern, front, of_front, section),
                     sides(pattern, back, of_back, section), false};
  };
  return {seam(left ? "side_L" : "side_R", 1), seam(left ? "side_R" : "side_L", 5),
          seam(left ? "shoulder_L" : "shoulder_R", 3)};
}

std::vector<OpenLoop> one_shoulder_loops(const Pattern& pattern, int front,
                                         const KnownPiece& of_front, int back,
                                         const KnownPiece& of_back) {
  const bool left = of_front.side > 0;
  const auto loop = [&](const char* name, LoopKind kind, int side, int section, bool front_first) {
    OpenLoop made{name, kind, side, {}};
    for (const bool of : {front_first, !front_first}) {
      const auto more =
          of ? sides(pattern, front, of_front, section) : sides(pattern, back, of_back, section);
      made.edges.insert(made.edges.end(), more.begin(), more.end());
    }
    return made;
  };
  return {loop("hem", LoopKind::hem, 0, 0, true),
          loop(left ? "armhole_L" : "armhole_R", LoopKind::armhole, left ? 1 : -1, 2, left),
          loop("neck", LoopKind::neck, 0, 4, true)};
}

}  // namespace loosefit::pattern
