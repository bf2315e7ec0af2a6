#include "loosefit/pattern/skirt_below.h"

#include <algorithm>
#include <cmath>

#include "loosefit/base/text.h"
#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::pattern {
namespace {

constexpr double kAlike = 1.1, kMostGathered = 2.5;  // of a waist over what it is sewn to

constexpr double kToWaist = 1.2;  // length of a bodice over its width at the underarms

std::vector<Stitch::Side> sides(const Pattern& pattern, const PieceAt& of, int section) {
  return of.piece->sections[section].sides(pattern.panels[of.panel], of.panel);
}

bool fits(const Pattern& pattern, const PieceAt& bodice, const PieceAt& skirt) {
  const double edge = bodice.piece->sections[0].length, waist = skirt.piece->sections[2].length;
  const bool named = words_of(pattern.panels[skirt.panel]).skirt;
  return waist * kAlike > edge && waist < (named ? kMostGathered : kAlike) * edge;
}

/// Whether it ends at the waist, not farther down.
bool is_short(const KnownPiece& bodice) {
  const std::vector<Section>& s = bodice.sections;
  const Vec2 along = (s[0].to - s[0].from).normalized();
  double length = 0;
  for (const Section& section : s)
    length = std::max(length, std::abs(geometry::cross(along, section.to - s[0].from)));
  return length < kToWaist * (s[1].to - s.back().from).norm();
}

}  // namespace

SkirtBelow know_skirt_below(const Pattern& pattern, PieceAt bodice_front, PieceAt bodice_back,
                            PieceAt skirt_front, PieceAt skirt_back) {
  if (!fits(pattern, bodice_front, skirt_front) || !fits(pattern, bodice_back, skirt_back))
    return {};
  SkirtBelow below;
  for (const PieceAt& bodice : {bodice_front, bodice_back})
    if (!is_short(*bodice.piece))
      below.doubts.push_back("piece " + printable(pattern.panels[bodice.panel].name) +
                             ": as long as a top that ends below the waist, the skirt may be worn "
                             "with it, not sewn to it");
  const auto seam = [&](const char* name, const PieceAt& a, int i, const PieceAt& b, int j) {
    return ChainSeam{name, sides(pattern, a, i), sides(pattern, b, j), false};
  };
  below.seams = {seam("skirt_side_L", skirt_front, 1, skirt_back, 3),
                 seam("skirt_side_R", skirt_front, 3, skirt_back, 1),
                 seam("waist_front", bodice_front, 0, skirt_front, 2),
                 seam("waist_back", bodice_back, 0, skirt_back, 2)};
  below.hem = {"hem", LoopKind::hem, 0, sides(pattern, skirt_front, 0)};
  const auto behind = sides(pattern, skirt_back, 0);
  below.hem.edges.insert(below.hem.edges.end(), behind.begin(), behind.end());
  return below;
}

}  // namespace loosefit::pattern
