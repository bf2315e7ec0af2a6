#pragma once
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "loosefit/io/pieces/drawn_piece.h"
#include "loosefit/io/pieces/left_out.h"

namespace loosefit::io {

/// A line of a part that may be an outline.
struct FreesewingLine {
  DrawnLine line;           ///< [m], y up
  std::vector<Vec2> nodes;  ///< ends of its curves
  std::string name;         ///< of the path; may be empty
  bool fabric = false;      ///< of class "fabric", which is the sew line; else of no class
  std::string place;        ///< where it stands, for messages: "at line 7"
};

/// A closed line of a part that is of another class: "lining", "canvas", "various help".
struct FreesewingOther {
  std::vector<Vec2> points;  ///< [m], y up
  std::string classes, place;
};

/// A part of a FreeSewing design as SVG or JSON has it [m], y up.
struct FreesewingPart {
  std::string name;                   ///< "teagan.front"
  std::string place;                  ///< where it stands, for messages: "at line 7"
  std::vector<FreesewingLine> lines;  ///< in the order of the file
  std::vector<FreesewingOther> others;
  std::vector<std::vector<Vec2>> folds;
  std::optional<Axis> grain;
  std::vector<Vec2> notches;
  std::vector<std::string> texts;  ///< that stand in it
  Axis middle;                     ///< the line x = 0 of the part, on which half pieces are drawn

  bool has_outline() const;
};

/// The pieces of a part. Its largest line of class "fabric" is the outline, open or closed; in
/// parts without one the largest of no class. Further closed ones of class "fabric" are holes where
/// they lie in an outline, and pieces of their own beside it; what else there is is told, closed
/// lines of other classes that are no line on a piece by their class.
/// FreeSewing draws front and back as halves from the line x = 0 of the part on, as "cut on fold"
/// says where all marks are drawn. Without these, a part called front or back whose outline begins
/// with a straight line there is one too. How often it is cut, its texts say (quantity.h); without
/// them sleeves, cuffs and legs are cut for both hands. A part that names a hand, as `frontLeft`,
/// is whole and cut once where the other hand's stands in the file as well. \param marked the file
/// draws such marks \param parts names of all parts of the file
std::vector<CountedPiece> drawn_freesewing(const FreesewingPart& part, bool marked,
                                           const std::set<std::string>& parts, LeftOut& left);

}  // namespace loosefit::io
