#include "loosefit/pattern/known_hood.h"

#include <optional>

#include "loosefit/base/text.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::pattern {
namespace {

/// Sections of a half in the order of its outline: of a left one neck, back, face; of a right one
/// neck, face, back.
constexpr int kNeck = 0;
int back_of(const KnownPiece& half) { return half.side > 0 ? 1 : 2; }

}  // namespace

KnownHood know_hood(const Pattern& pattern, const std::vector<int>& panels, const OpenLoop& neck,
                    double front_middle) {
  std::vector<KnownHood::Part> halves;
  std::optional<int> between;
  std::optional<Strip> strip;
  for (const int p : panels) {
    const Panel& panel = pattern.panels[p];
    const PieceWords w = words_of(panel);
    if (!w.hood || w.pocket) continue;  // its facing or lining
    const std::vector<Section> sections = outline_sections(panel);
    if (auto half = as_hood_half(sections)) {
      halves.push_back({p, *half});
    } else if (auto straight = as_strip(sections); straight && !between) {
      between = p;
      strip = straight;
    }
  }
  KnownHood hood;
  if (halves.size() != 2) return hood;
  for (const KnownHood::Part& half : halves) {
    const Panel& panel = pattern.panels[half.panel];
    const PieceWords w = words_of(panel);
    if ((w.left && half.piece.side < 0) || (w.right && half.piece.side > 0))
      hood.doubts.push_back("piece " + printable(panel.name) +
                            ": its name and its outline say different sides of a hood");
  }
  if (halves[0].piece.side == halves[1].piece.side) {
    hood.doubts.push_back("both halves of the hood, " +
                          printable(pattern.panels[halves[0].panel].name) + " and " +
                          printable(pattern.panels[halves[1].panel].name) +
                          ", are for the same side: one should be the mirror image");
    return hood;
  }
  if (halves[0].piece.side < 0) std::swap(halves[0], halves[1]);
  const auto sides = [&](const KnownHood::Part& half, int section) {
    return half.piece.sections[section].sides(pattern.panels[half.panel], half.panel);
  };
  const auto back = [&](const KnownHood::Part& half) { return sides(half, back_of(half.piece)); };
  const KnownHood::Part &left = halves[0], &right = halves[1];
  // From the middle of the front round the wearer's left: against the way of the neck.
  std::vector<Stitch::Side> round = sides(left, kNeck);
  if (between) {
    // Seen from outside, behind: the second end is at the neck, from the left to the right.
    const auto of_strip = [&](const Section& s) {
      return s.sides(pattern.panels[*between], *between);
    };
    const std::vector<Stitch::Side> end = of_strip(strip->second_end);
    round.insert(round.end(), end.begin(), end.end());
    hood.seams.push_back({"hood_R", back(right), of_strip(strip->side), false});
    hood.seams.push_back({"hood_L", back(left), of_strip(strip->other_side), false});
  } else {
    hood.seams.push_back({"hood", back(left), back(right), false});
  }
  const std::vector<Stitch::Side> rest = sides(right, kNeck);
  round.insert(round.end(), rest.begin(), rest.end());
  ChainSeam at_neck{"hood_neck", round, neck.edges, false};
  at_neck.begin = front_middle;
  hood.seams.push_back(std::move(at_neck));
  hood.parts = {left, right};
  if (between) {
    KnownPiece piece;
    piece.role = PieceRole::hood;
    hood.parts.push_back({*between, piece});
  }
  return hood;
}

}  // namespace loosefit::pattern
