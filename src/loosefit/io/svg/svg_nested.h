#pragma once
#include <string>
#include <vector>

#include "loosefit/io/pieces/left_out.h"
#include "loosefit/io/svg/svg_lines.h"

namespace loosefit::io {

/// Without rectangles that cover the page or several other closed lines, which are frames, and
/// without small unnamed squares beside the pieces of whole centimetres or inches, by which prints
/// are checked; a warning names each. One that is called after a piece is none, and holes are no
/// other lines. \param unit of the drawing [m]
std::vector<SvgLine> without_frames(const SvgDocument& document, std::vector<SvgLine> closed,
                                    double unit, LeftOut& left);

/// Per closed line the index of one round it; −1. A line that is called a hole belongs to one in
/// which a part of it lies.
std::vector<int> lines_round(const SvgDocument& document, const std::vector<SvgLine>& closed);

/// Names of the closed lines that a text calls a hole, "neck hole", by standing in or beside them;
/// empty ones of the others. A text that speaks of a hole where there is no such line is told.
std::vector<std::string> holes_by_text(const SvgDocument& document, double unit,
                                       const std::vector<SvgLine>& closed,
                                       const std::vector<int>& within, LeftOut& left);

}  // namespace loosefit::io
