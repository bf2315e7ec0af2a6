#pragma once
#include <string>
#include <vector>

#include "loosefit/io/pieces/drawn_piece.h"
#include "loosefit/io/pieces/left_out.h"
#include "loosefit/io/svg/svg_document.h"

namespace loosefit::io {

/// Pieces of a drawing that FreeSewing did not write: closed lines that lie in no other one, and
/// open ones of a group that close together. Frames, backgrounds and test squares are left out. A
/// closed line called seam within a piece is its outline, one called hole, or drawn in one path
/// with the outline, is cut out; all others in it are told. Of outlines that lie in each other, as
/// those of graded sizes, the one is taken whose label, or that of a group round it, has `size` as
/// a word, with the sew line of that size (svg_sizes.h); the largest one if that is empty. A piece
/// is called by its label, else that of a group round it; a label that is only that of the size
/// gives way to that of the group. \throws InvalidInput for more than 1000 closed lines,
/// and for a size that is in the label of none or several of them.
std::vector<CountedPiece> drawn_pieces(const SvgDocument& document, double unit,
                                       const std::string& file, const std::string& size,
                                       LeftOut& left);

}  // namespace loosefit::io
