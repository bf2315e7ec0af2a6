#include "loosefit/pattern/sleeve_doubts.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "loosefit/base/text.h"
#include "loosefit/pattern/cap_scoop.h"
#include "loosefit/pattern/piece_facing.h"
#include "loosefit/pattern/piece_names.h"

namespace loosefit::pattern {
namespace {

/// A side of an armhole.
struct Hole {
  bool front = false;
  int side = 0;  ///< of the wearer: +1 left, −1 right
};

class Judge {
 public:
  Judge(const Pattern& pattern, const KnownGarment& known) : pattern_(pattern), known_(known) {}

  std::vector<std::string> doubts() {
    for (int p = 0; p < static_cast<int>(pattern_.panels.size()); ++p) {
      const PieceRole role = known_.pieces[p].role;
      if (role == PieceRole::sleeve && known_.pieces[p].sections.size() == 4)
        whole(p);
      else if (words_of(pattern_.panels[p]).sleeve && role != PieceRole::sleeve)
        half(p);
    }
    return std::move(doubts_);
  }

 private:
  void say(const std::string& why) { doubts_.push_back(why); }
  std::string name(int p) const { return printable(pattern_.panels[p].name); }
  static const char* hand(int side) { return side > 0 ? "left" : "right"; }

  /// The armhole that an edge of the trunk is part of.
  std::optional<Hole> hole_of(const Stitch::Side& side) const {
    const KnownPiece& piece = known_.pieces[side.panel];
    const bool front = piece.role == PieceRole::front;
    if ((!front && piece.role != PieceRole::back) || piece.sections.size() != 8) return {};
    for (const int section : {2, 6})
      for (const Stitch::Side& of :
           piece.sections[section].sides(pattern_.panels[side.panel], side.panel))
        if (of.edge == side.edge) return Hole{front, (section == 2) == front ? 1 : -1};
    return {};
  }

  std::optional<Hole> hole_at(int panel, int edge) const {
    for (const Stitch& stitch : pattern_.stitches) {
      const Stitch::Side& own = stitch.first.panel == panel ? stitch.first : stitch.second;
      const Stitch::Side* other = other_side(stitch, panel);
      if (other && own.edge == edge) return hole_of(*other);
    }
    return {};
  }

  void whole(int p) {
    const Section& cap = known_.pieces[p].sections[2];
    std::vector<Hole> way;  // along the cap
    for (const Stitch::Side& side : cap.sides(pattern_.panels[p], p))
      if (const auto hole = hole_at(p, side.edge)) way.push_back(*hole);
    if (way.empty()) return;
    const int side = way.front().side;
    if (std::ranges::any_of(way, [&](const Hole& hole) { return hole.side != side; }))
      return say("sleeve " + name(p) + " is sewn to armholes of both sides");
    if (wrong_hand(p, side)) return;
    if (std::ranges::all_of(way, [&](const Hole& hole) { return hole.front == way[0].front; }))
      return say("sleeve " + name(p) + " is sewn to the " + (way[0].front ? "front" : "back") +
                 " alone");
    // Seen from outside, the outline of a cap runs from back to front at a left armhole.
    if (way.front().front == (side > 0))
      return say("sleeve " + name(p) + " is sewn to front and back in the wrong order for the " +
                 hand(side) +
                 " armhole: it is turned inside out, or its armholes are listed the "
                 "wrong way round");
    const double scoop = cap_scoop(pattern_.panels[p], cap);
    if (std::abs(scoop) > kScoopTells && (scoop > 0) != way.front().front)
      say("the half of the cap of " + name(p) +
          " that is cut out more, as the front of a sleeve is, is sewn to the back: it may be the "
          "sleeve of the other arm");
  }

  bool wrong_hand(int p, int side) {
    const PieceWords w = words_of(pattern_.panels[p]);
    const int named = int(w.left) - int(w.right);
    if (named == 0 || named == side) return false;
    say("piece " + name(p) + " is called " + hand(named) + " and sewn to the " + hand(side) +
        " armhole");
    return true;
  }

  void half(int p) {
    const PieceWords w = words_of(pattern_.panels[p]);
    for (int e = 0; e < static_cast<int>(pattern_.panels[p].edges.size()); ++e) {
      const auto hole = hole_at(p, e);
      if (!hole) continue;
      if (wrong_hand(p, hole->side)) return;
      if (w.front != w.back && w.front != hole->front)
        return say("piece " + name(p) + " is called " + (w.front ? "front" : "back") +
                   " and sewn to the " + (hole->front ? "front" : "back"));
    }
  }

  const Pattern& pattern_;
  const KnownGarment& known_;
  std::vector<std::string> doubts_;
};

}  // namespace

std::vector<std::string> sleeve_doubts(const Pattern& pattern, const KnownGarment& known) {
  return Judge(pattern, known).doubts();
}

}  // namespace loosefit::pattern
