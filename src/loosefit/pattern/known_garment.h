#pragma once
#include <string>
#include <vector>

#include "loosefit/pattern/sections.h"
#include "loosefit/pattern/sew_chains.h"

namespace loosefit::pattern {

/// What a piece is in a garment that is known by its topology.
enum class PieceRole {
  unknown,
  front,
  back,
  sleeve,
  front_leg,
  back_leg,
  front_skirt,
  back_skirt,
  band
};

/// A piece, told by name and outline.
struct KnownPiece {
  PieceRole role = PieceRole::unknown;
  int side = 0;         ///< of the wearer: +1 left, −1 right, 0 across the middle
  bool upright = true;  ///< y points upwards; otherwise the piece stands on its head
  /// Of trunks: hem, side, armhole, shoulder, neck, shoulder, armhole, side; of raglan shirts hem,
  /// side, raglan, neck, raglan, side. Of sleeves: cuff, underarm, cap, underarm; cuff, underarm,
  /// raglan, neck, raglan, underarm. Of skirts: hem, side, waist, side. Of legs: hem and, in the
  /// order of the outline, the next ones of hem, outseam, waist, crotch, inseam or the other way
  /// round.
  std::vector<Section> sections;
};

/// A garment of known topology.
struct KnownGarment {
  std::string kind;                 ///< "t-shirt", "raglan shirt", "tank top", …; empty: none
  std::vector<KnownPiece> pieces;   ///< per panel; unknown ones are no part of it
  std::vector<ChainSeam> seams;     ///< of the topology
  std::vector<std::string> doubts;  ///< why nobody should sew it unasked; empty: the only way

  bool certain() const { return !kind.empty() && doubts.empty(); }
};

/// Tells T-shirts, long-sleeve and raglan shirts (front, back, two sleeves in one piece each), tank
/// tops, trousers (two fronts, two backs) and skirts (front, back) by the sections of their
/// outlines, by symmetry and by names; bands at their edges (known_bands.h); and how they are sewn.
/// Doubts: pieces that are no part of it, lengths of a seam that differ by more than 2 % and that
/// no band gathers, more than one way to tell a piece.
KnownGarment know_garment(const Pattern& pattern);

}  // namespace loosefit::pattern
