#include "loosefit/pattern/known_bands.h"

#include <algorithm>
#include <set>

#include "loosefit/base/text.h"
#include "loosefit/pattern/known_pieces.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::pattern {
namespace {

constexpr double kShortest = 0.6, kLongest = 1.03;  ///< of a band over its loop

bool says_a_band(const PieceWords& w) {
  return w.neck || w.armhole || w.cuff || w.waist || w.hem || w.sleeve;
}

/// A name that says nothing allows any loop; a waistband may be that of a jacket, at its hem.
bool allows(const PieceWords& w, LoopKind kind, bool has_waist) {
  if (!says_a_band(w)) return true;
  switch (kind) {
    case LoopKind::neck:
      return w.neck;
    case LoopKind::armhole:
      return w.armhole;
    case LoopKind::wrist:
      return w.cuff || w.sleeve;
    case LoopKind::waist:
      return w.waist;
    default:
      return w.hem || w.cuff || (w.waist && !has_waist);
  }
}

const char* name_of(LoopKind kind) {
  switch (kind) {
    case LoopKind::neck:
      return "neck";
    case LoopKind::armhole:
      return "armholes";
    case LoopKind::wrist:
      return "wrists";
    case LoopKind::waist:
      return "waist";
    default:
      return "hem";
  }
}

}  // namespace

KnownBands know_bands(const Pattern& pattern, const std::vector<int>& panels,
                      const std::vector<OpenLoop>& loops) {
  KnownBands known;
  std::set<int> taken;  // loops
  const bool has_waist = std::any_of(loops.begin(), loops.end(), [](const OpenLoop& loop) {
    return loop.kind == LoopKind::waist;
  });
  for (const int p : panels) {
    const Panel& panel = pattern.panels[p];
    const PieceWords w = words_of(panel);
    const auto strip = as_strip(outline_sections(panel));
    if (!strip || w.pocket || w.hood || w.yoke) continue;
    std::vector<int> fit;
    std::set<LoopKind> kinds;
    for (std::size_t l = 0; l < loops.size(); ++l) {
      const OpenLoop& loop = loops[l];
      const double ratio = strip->side.length / chain_length(pattern, loop.edges);
      const bool other_side = (w.left && loop.side < 0) || (w.right && loop.side > 0);
      const bool fits = ratio >= kShortest && ratio <= kLongest;
      if (taken.count(static_cast<int>(l)) || !allows(w, loop.kind, has_waist) || other_side ||
          !fits)
        continue;
      fit.push_back(static_cast<int>(l));
      kinds.insert(loop.kind);
    }
    if (fit.empty()) continue;
    const OpenLoop& loop = loops[fit.front()];
    if (kinds.size() > 1)
      known.doubts.push_back("band " + printable(panel.name) + " fits more than one edge; the " +
                             name_of(loop.kind) + " is taken");
    else if (!says_a_band(w))
      known.doubts.push_back("piece " + printable(panel.name) + " is taken for a band at the " +
                             name_of(loop.kind) + " by its length alone");
    taken.insert(fit.front());
    known.bands.push_back({p,
                           fit.front(),
                           {"band_" + loop.name, strip->side.sides(panel, p), loop.edges, false},
                           {"band_ends_" + loop.name, strip->first_end.sides(panel, p),
                            strip->second_end.sides(panel, p), false}});
  }
  return known;
}

}  // namespace loosefit::pattern
