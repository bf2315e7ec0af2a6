#pragma once
#include <string>

#include "loosefit/io/pieces/drawn_piece.h"

namespace loosefit::io {

/// Whether a text speaks of a fold, what it says of a count left out: "1 + mirror" does not.
bool speaks_of_fold(const std::string& text);

/// Tells in the notes of a piece that a text of it speaks of a fold that no line marks. Where the
/// text says that it is cut there ("cut 1 on fold", "im Bruch") the piece may be half of what is
/// sewn, which `half_without_fold` keeps; "fold the hem up" says nothing of that.
/// \param what  "its text", "its name" \param mark  what would mark it: "no line called \"fold\""
void note_missing_fold(DrawnPiece& piece, const std::string& what, const std::string& text,
                       const std::string& mark);

}  // namespace loosefit::io
