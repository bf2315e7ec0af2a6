#include "loosefit/pattern/skirt_below.h"

#include "loosefit/pattern/piece_names.h"

namespace loosefit::pattern {
namespace {

constexpr double kAlike = 1.1, kMostGathered = 2.5;  // of a waist over what it is sewn to

std::vector<Stitch::Side> sides(const Pattern& pattern, const PieceAt& of, int section) {
  return of.piece->sections[section].sides(pattern.panels[of.panel], of.panel);
}

bool fits(const Pattern& pattern, const PieceAt& bodice, const PieceAt& skirt) {
  const double edge = bodice.piece->sections[0].length, waist = skirt.piece->sections[2].length;
  const bool named = words_of(pattern.panels[skirt.panel]).skirt;
  return waist * kAlike > edge && waist < (named ? kMostGathered : kAlike) * edge;
}

}  // namespace

SkirtBelow know_skirt_below(const Pattern& pattern, PieceAt bodice_front, PieceAt bodice_back,
                            PieceAt skirt_front, PieceAt skirt_back) {
  if (!fits(pattern, bodice_front, skirt_front) || !fits(pattern, bodice_back, skirt_back))
    return {};
  const auto seam = [&](const char* name, const PieceAt& a, int i, const PieceAt& b, int j) {
    return ChainSeam{name, sides(pattern, a, i), sides(pattern, b, j), false};
  };
  SkirtBelow below;
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
