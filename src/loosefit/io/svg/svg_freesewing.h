#pragma once
#include <vector>

#include "loosefit/io/pieces/freesewing_piece.h"
#include "loosefit/io/svg/svg_document.h"

namespace loosefit::io {

/// Pieces of a drawing that FreeSewing wrote: paths of class "fabric" without "sa" in the groups
/// "fs-stack-DESIGN.PART-part-DESIGN.PART". \param unit length of a unit of the drawing [m]
std::vector<CountedPiece> freesewing_pieces(const SvgDocument& document, double unit,
                                            LeftOut& left);

}  // namespace loosefit::io
