#pragma once
#include <string>
#include <vector>

#include "loosefit/io/svg/svg_pieces.h"

namespace loosefit::io {

/// Pieces of a drawing that FreeSewing wrote: paths of class "fabric" without "sa" in the groups
/// "fs-stack-DESIGN.PART-part-DESIGN.PART". \param unit length of a unit of the drawing [m]
std::vector<SvgPiece> freesewing_pieces(const SvgDocument& document, double unit,
                                        std::vector<std::string>& unused);

}  // namespace loosefit::io
