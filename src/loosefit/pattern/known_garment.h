#pragma once
#include <string>
#include <vector>

#include "loosefit/pattern/known_pieces.h"
#include "loosefit/pattern/sew_chains.h"

namespace loosefit::pattern {

/// A garment of known topology.
struct KnownGarment {
  std::string kind;                ///< "t-shirt", "raglan shirt", "tank top", …; empty: none
  std::vector<KnownPiece> pieces;  ///< per panel; unknown ones are no part of it
  std::vector<ChainSeam> seams;    ///< of the topology
  /// Of the doubts those about names that say other pieces than outlines do; they hold however it
  /// is sewn.
  std::vector<std::string> names_against_shapes;
  std::vector<std::string> doubts;  ///< why nobody should sew it unasked; empty: the only way
  bool unnamed = false;  ///< which pieces are before and which behind the wearer, nothing tells

  bool certain() const { return !kind.empty() && doubts.empty(); }
};

/// Tells T-shirts, long-sleeve and raglan shirts (front, back, two sleeves in one piece each or in
/// halves: known_half_sleeves.h), tank tops, one-shoulder tops (known_one_shoulder.h), these with a
/// skirt below (skirt_below.h), trousers (two fronts, two backs; two legs in one piece) and skirts
/// (known_skirt.h) by the sections of their outlines, by symmetry and by names; hoods at their neck
/// (known_hood.h) and bands at their edges (known_bands.h); and how they are sewn. Doubts: pieces
/// that are no part of it, lengths of a seam that differ by more than 2 % and that no band gathers,
/// more than one way to tell a piece, a hole in a skirt that may be a neck.
KnownGarment know_garment(const Pattern& pattern);

}  // namespace loosefit::pattern
