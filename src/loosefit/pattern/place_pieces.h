#pragma once
#include <string>
#include <vector>

#include "loosefit/pattern/known_garment.h"
#include "loosefit/pattern/piece_facing.h"

namespace loosefit::pattern {

/// Places the pieces of a sewn pattern that has no placement, or only a sheet to lie on: fronts
/// before the middle, backs behind it, sleeves to the sides along arms held a little down, all by
/// nobody's measures; whoever puts the garment on a body moves them there (drape/arrange_panels.h).
/// Which way each piece faces is told by tell_facings (pattern/piece_facing.h). Heights follow the
/// seams. What is sewn at its top alone, as a tabard, is placed above
/// everybody's neck. Labels "body", "arm" and "leg" are set where there are none, and those of the
/// armhole of a garment that hangs on one shoulder. A known piece that stands on its head is turned
/// round. \return what had to be assumed. \throws GeometryError naming the pieces that nothing
/// tells where
///         they go: no seam, or neither name nor seam to a piece with one.
/// \param turns by panel, where somebody says which way up it lies
std::vector<std::string> place_pieces(Pattern& pattern, const QuarterTurns& turns = {});

}  // namespace loosefit::pattern
