#pragma once
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "loosefit/io/pieces/drawn_piece.h"

namespace loosefit::io {

/// A part of a FreeSewing design as SVG or JSON has it [m], y up.
struct FreesewingPart {
  std::string name;         ///< "teagan.front"
  DrawnLine seam;           ///< path of class "fabric", which is the sew line
  std::vector<Vec2> nodes;  ///< ends of its curves
  std::optional<Axis> fold, grain;
  std::vector<Vec2> notches;
  Axis middle;  ///< the line x = 0 of the part, on which half pieces are drawn
};

/// FreeSewing draws front and back as halves from the line x = 0 of the part on, as "cut on fold"
/// says where all marks are drawn. Without these, a part called front or back whose outline begins
/// with a straight line there is one too. Sleeves, cuffs and legs are cut for both hands.
/// A part that names a hand, as `frontLeft`, is whole and cut once where the other hand's stands in
/// the file as well.
/// \param marked the file draws such marks \param parts names of all parts of the file
/// \param count how often it is cut
DrawnPiece drawn_freesewing(FreesewingPart part, bool marked, const std::set<std::string>& parts,
                            PieceCount& count);

}  // namespace loosefit::io
