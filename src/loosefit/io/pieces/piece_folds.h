#pragma once
#include <string>
#include <vector>

#include "loosefit/io/pieces/drawn_piece.h"

namespace loosefit::io {

/// What came of the fold marks of a piece.
struct Unfolded {
  int times = 0;                   ///< the marks at which it was unfolded
  bool beside = false;             ///< a mark lies on no part of the outline, nor in its middle
  std::vector<std::string> notes;  ///< marks that were not used, and holes that cannot be unfolded
};

/// Unfolds a piece at each of its fold marks, its notches and holes with it. A mark is the line
/// between its ends where part of the outline lies on that, as the brackets of FreeSewing, else
/// each of its sides on which part of the outline lies. Marks on one line are one. A second mark is
/// used at right angles to the first one: cloth folded in four. A hole that is drawn up to the fold
/// goes on beyond it, one apart from it is cut twice, one that is symmetric about it once.
Unfolded unfold_piece(DrawnPiece& piece);

}  // namespace loosefit::io
