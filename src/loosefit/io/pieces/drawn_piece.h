#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "loosefit/io/pieces/piece_outline.h"
#include "loosefit/pattern/notch.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::io {

/// A line by two points that lie apart [m].
using Axis = std::pair<Vec2, Vec2>;

/// How often a piece is cut.
struct PieceCount {
  int as_drawn = 1, mirrored = 0;
};

/// One piece as a file draws it, whatever its format: metres, y up, seen from the outside.
struct DrawnPiece {
  std::string name;
  Outline outline;            ///< cleaned; empty: it is none
  std::optional<Axis> fold;   ///< a half piece goes on beyond it
  std::optional<Axis> grain;  ///< the warp; none: y
  std::vector<Vec2> notches;
  std::vector<std::string> notes;  ///< what had to be assumed for it
  std::string fault;               ///< why it has no outline
  bool on_sew_line = false;        ///< the outline is where it is sewn, not where it is cut
};

/// A piece as a panel, or why it cannot be one.
struct PiecePanel {
  pattern::Panel
      panel;  ///< grain along y, counter-clockwise, edges e1, e2, …, low corner at (·, 0)
  std::vector<pattern::Notch> notches;  ///< of panel 0
  std::string fault;                    ///< empty: the panel is sound
  std::vector<std::string> notes;       ///< what had to be assumed for it
  bool on_sew_line = false;
  bool unfolded = false;  ///< from a half piece
};

/// The outline of a closed line [m] whose edges begin where it turns by more than 20 degrees at a
/// node; what is wrong with it goes to piece.fault.
void set_outline(DrawnPiece& piece, std::vector<Vec2> points, const std::vector<Vec2>& nodes);

/// Turns grain lines about that point down: which end of one is up no file says, and programs draw
/// their arrows either way. Up is up in the drawing, so that no piece turns by more than a right
/// angle. Where pieces lie sideways, as those of Gerber do, up is the side to which most of their
/// grain lines point, to the right where as many point to the left, the same one for all of them.
void point_grains_up(const std::vector<DrawnPiece*>& pieces);

/// Unfolds a half piece at its fold, turns its grain to y, cuts its outline into edges at the
/// corners and puts every notch on the nearest edge within 3 cm, a wide allowance.
PiecePanel panel_of_piece(DrawnPiece piece);

/// The piece turned over, x → −x: edges keep their names.
PiecePanel mirrored_piece(const PiecePanel& piece);

}  // namespace loosefit::io
