#pragma once
#include <string>
#include <vector>

#include "loosefit/io/pieces/drawn_piece.h"
#include "loosefit/io/svg/svg_document.h"

namespace loosefit::io {

/// A piece of an SVG drawing, in its units but y up.
struct SvgPiece {
  DrawnPiece piece;
  PieceCount count;
  int line = 0;  ///< of the file
};

/// Pieces of a drawing that FreeSewing wrote: paths of class "fabric" without "sa" in the groups
/// "fs-stack-DESIGN.PART-part-DESIGN.PART". \param unit length of a unit of the drawing [m]
std::vector<SvgPiece> freesewing_pieces(const SvgDocument& document, double unit,
                                        std::vector<std::string>& unused);

/// Pieces of any other drawing: closed lines that lie in no other one, and open ones of a group
/// that close together. Frames, backgrounds and test squares are left out. A closed line called
/// seam within a piece is its outline. \throws InvalidInput for more than 1000 closed lines.
std::vector<SvgPiece> drawn_pieces(const SvgDocument& document, double unit,
                                   const std::string& file, std::vector<std::string>& unused);

}  // namespace loosefit::io
