#pragma once
#include <string>
#include <vector>

#include "loosefit/pattern/known_bands.h"
#include "loosefit/pattern/known_pieces.h"

namespace loosefit::pattern {

/// A piece and what it is known as.
struct PieceAt {
  int panel = 0;
  const KnownPiece* piece = nullptr;
};

/// How the skirt of a dress is sewn.
struct SkirtBelow {
  std::vector<ChainSeam> seams;  ///< its sides, and its waist to the lower edge of the bodice
  OpenLoop hem;
  std::vector<std::string> doubts;  ///< why nobody should sew it unasked

  bool found() const { return !seams.empty(); }
};

/// Front and back of a skirt (as_skirt) to those of a bodice, whose lower edges are their first
/// sections. Nothing where a waist is shorter than that edge by more than a tenth, or longer by
/// more than it may be gathered: a tenth, or two and a half times where a name says skirt. A bodice ends at the waist: one that is
/// longer than 1.2 times its width at the underarms may be a top worn over or in the skirt, which
/// is a doubt.
SkirtBelow know_skirt_below(const Pattern& pattern, PieceAt bodice_front, PieceAt bodice_back,
                            PieceAt skirt_front, PieceAt skirt_back);

}  // namespace loosefit::pattern
