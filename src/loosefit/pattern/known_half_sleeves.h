#pragma once
#include <string>
#include <utility>
#include <vector>

#include "loosefit/pattern/known_bands.h"
#include "loosefit/pattern/known_pieces.h"

namespace loosefit::pattern {

/// An armhole that has no sleeve yet: its edges on front and back.
struct OpenArmhole {
  std::vector<Stitch::Side> front, back;
};

/// Two sleeves in halves, a front and a back each.
struct KnownHalfSleeves {
  std::vector<std::pair<int, KnownPiece>> pieces;  ///< panel, what it is
  std::vector<ChainSeam> seams;
  std::vector<OpenLoop> loops;      ///< ends of the sleeves
  std::vector<std::string> doubts;  ///< why nobody should sew them unasked

  bool found() const { return !pieces.empty(); }
};

/// Of these panels the four that are halves of sleeves: called sleeve, two of them front and two
/// back, with four sections each, one of which is as long as its side of the armhole by 15 % (the
/// cap). The longer neighbour of a cap is the seam on top of the arm, the other one that below it;
/// which comes next in the outline tells the hand. Doubts: a name that says the other hand,
/// and neighbours that are as long by 1 cm where no name says the hand.
KnownHalfSleeves know_half_sleeves(const Pattern& pattern, const std::vector<int>& panels,
                                   const OpenArmhole& left, const OpenArmhole& right);

}  // namespace loosefit::pattern
