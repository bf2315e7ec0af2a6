#pragma once
#include <string>
#include <vector>

#include "loosefit/io/svg/svg_lines.h"

namespace loosefit::io {

/// Whether a group is round a shape; no group (−1) is not.
bool stands_in(const SvgShape& shape, int group);

/// The sew line of a cut line: the largest one within it. Where the cut line was picked among
/// others by its size, those of larger sizes may lie within it as well, if the allowance is wider
/// than the grade. Then it is the one that has the size in its labels; else that in the cut line's
/// own group, if no other outline stands there; else, if there is one for each outline, the one
/// that comes as the cut line does by area; else the largest that no label and no group gives to
/// another outline, which is told.
/// \param others  outlines of other sizes
/// \param seams  all lines called seam, of the other sizes too
/// \return null: there is none
const SvgLine* seam_of_size(const SvgDocument& document, const SvgLine& cut,
                            const std::vector<const SvgLine*>& others,
                            std::vector<const SvgLine*> seams, const std::string& size,
                            std::vector<std::string>& notes);

}  // namespace loosefit::io
