#pragma once
#include <string>
#include <vector>

#include "loosefit/pattern/known_bands.h"
#include "loosefit/pattern/known_pieces.h"

namespace loosefit::pattern {

/// A hood at the neck of a known garment.
struct KnownHood {
  struct Part {
    int panel = 0;
    KnownPiece piece;
  };
  std::vector<Part> parts;          ///< left, right and, of a hood with one, the strip between them
  std::vector<ChainSeam> seams;     ///< halves to each other or to the strip, and to the neck
  std::vector<std::string> doubts;  ///< why nobody should sew it unasked

  bool found() const { return !parts.empty(); }
};

/// Tells two halves of a hood, and a strip between them, of panels whose names say hood.
/// \param neck its loop, the front first \param front_middle share of the loop's length at the
/// middle of the front, where the hood is open
KnownHood know_hood(const Pattern& pattern, const std::vector<int>& panels, const OpenLoop& neck,
                    double front_middle);

}  // namespace loosefit::pattern
