#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "loosefit/io/pieces/piece_outline.h"
#include "loosefit/io/pieces/quantity.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::io {

/// A line by two points that lie apart [m].
using Axis = std::pair<Vec2, Vec2>;

/// One piece as a file draws it, whatever its format: metres, y up, seen from the outside.
struct DrawnPiece {
  std::string name;
  Outline outline;                       ///< cleaned; empty: it is none
  std::vector<std::vector<Vec2>> folds;  ///< lines that mark where a half piece goes on beyond them
  std::vector<pattern::PanelHole> holes;  ///< lines that are cut out of it
  std::optional<Axis> grain;              ///< the warp; none: y
  std::vector<Vec2> notches;
  std::vector<std::string> notes;  ///< what had to be assumed for it
  std::string fault;               ///< why it has no outline
  bool on_sew_line = false;        ///< the outline is where it is sewn, not where it is cut
  bool half_without_fold = false;  ///< cut on a fold by its texts, and no line marks that
};

/// A piece, how often it is cut, and where it stands.
struct CountedPiece {
  DrawnPiece piece;
  PieceCount count = {};
  std::string place;     ///< for messages: "at line 7"
  bool of_size = false;  ///< picked among several by the size that was asked for
};

/// The outline of a closed line [m] whose edges begin where it turns by more than 20 degrees at a
/// node; what is wrong with it goes to piece.fault.
void set_outline(DrawnPiece& piece, std::vector<Vec2> points, const std::vector<Vec2>& nodes);

/// Turns grain lines about that point down: which end of one is up no file says, and programs draw
/// their arrows either way. Up is up in the drawing, so that no piece turns by more than a right
/// angle. Where pieces lie sideways, as those of Gerber do, up is the side to which most of their
/// grain lines point, to the right where as many point to the left, the same one for all of them.
void point_grains_up(const std::vector<DrawnPiece*>& pieces);

}  // namespace loosefit::io
