#pragma once
#include "loosefit/io/dxf/dxf_pieces.h"
#include "loosefit/io/pieces/drawn_piece.h"

namespace loosefit::io {

/// Outline: the sew line (layer 14) where it is closed and within the boundary (layer 1); else a
/// closed line on layer 8 that lies a seam allowance inside the boundary (Valentina); else the
/// boundary, or its finer copy on layer 84 where that is one. Edges: the lines the outline is drawn
/// with, closed ones cut at their corners. The fold is the mirror line (layer 6), the grain layer
/// 7; notches are on layers 4 and 80 to 83. Layers: ASTM D6673-10. \param metre length of one file
/// unit [m]
DrawnPiece drawn_piece(const DxfPiece& piece, double metre);

}  // namespace loosefit::io
