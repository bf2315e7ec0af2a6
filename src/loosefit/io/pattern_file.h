#pragma once
#include <string>
#include <vector>

#include "loosefit/pattern/notch.h"
#include "loosefit/pattern/pattern.h"
#include "loosefit/pattern/piece_facing.h"

namespace loosefit::io {

/// What is wanted of a file that holds several sizes or is unclear about its units.
struct PatternWish {
  std::string size;   ///< empty: the sample size, or the only one
  std::string units;  ///< mm, cm, m or inch; empty: found (io/pieces/file_units.h)
};

/// A pattern read from a file and what had to be assumed for it.
struct PatternFile {
  pattern::Pattern pattern;
  std::vector<std::string> warnings;
  std::vector<pattern::Notch> notches;  ///< that the file has; seams are proposed by them
  std::vector<std::string> about;       ///< what the file says of itself: format, units, sizes
  std::vector<std::string> used;        ///< the pieces that were taken, each with how
  std::vector<std::string> unused;      ///< what stands in the file and was not used, and why
  std::vector<std::string> doubts;      ///< of its pieces: unasked, they are not sewn
  pattern::QuarterTurns turns;          ///< that a side file asks for
  bool placed = true;           ///< it says where its panels start, or it was told by what they are
  std::string not_placed;       ///< why it could not be told
  std::string not_placed_hint;  ///< what to do about that; empty: seams are missing
};

}  // namespace loosefit::io
