#pragma once
#include <vector>

#include "loosefit/io/dxf/dxf_pieces.h"
#include "loosefit/io/pieces/drawn_piece.h"

namespace loosefit::io {

/// Outline: the sew line (layer 14) where it is closed and within the boundary (layer 1); else a
/// closed line on layer 8 that lies a seam allowance inside the boundary (Valentina); else the
/// boundary, or its finer copy on layer 84 where that is one. Edges: the lines the outline is drawn
/// with, closed ones cut at their corners. Folds are mirror lines (layer 6), the grain layer
/// 7; notches are on layers 4 and 80 to 83. Closed lines within the boundary on its layer and on
/// layer 11 are cut out, those beside it are pieces of their own. Layers: ASTM D6673-10. \param
/// metre length of one file unit [m] \return one or more, the largest first; one without an outline
/// says why
std::vector<DrawnPiece> pieces_of_block(const DxfPiece& piece, double metre);

}  // namespace loosefit::io
