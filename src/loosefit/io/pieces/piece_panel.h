#pragma once
#include <string>
#include <vector>

#include "loosefit/io/pieces/drawn_piece.h"
#include "loosefit/pattern/notch.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::io {

/// A piece as a panel, or why it cannot be one.
struct PiecePanel {
  pattern::Panel
      panel;  ///< grain along y, counter-clockwise, edges e1, e2, …, low corner at (·, 0)
  std::vector<pattern::Notch> notches;  ///< of panel 0
  std::string fault;                    ///< empty: the panel is sound
  std::vector<std::string> notes;       ///< what had to be assumed for it
  bool on_sew_line = false;
  bool half_without_fold = false;  ///< DrawnPiece::half_without_fold
  int unfolded = 0;                ///< at how many fold lines
};

/// Unfolds a half piece at its folds, turns its grain to y, cuts its outline into edges at the
/// corners, cuts its holes out and puts every notch on the nearest edge within 3 cm, a wide
/// allowance. A hole that cannot be cut is told in the notes by its name: one that touches the
/// outline or another hole, and one of less than 4 cm2.
PiecePanel panel_of_piece(DrawnPiece piece);

/// The piece turned over, x → −x: edges keep their names.
PiecePanel mirrored_piece(const PiecePanel& piece);

}  // namespace loosefit::io
