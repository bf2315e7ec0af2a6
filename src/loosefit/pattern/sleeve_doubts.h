#pragma once
#include <string>
#include <vector>

#include "loosefit/pattern/known_garment.h"

namespace loosefit::pattern {

/// What is told of the sleeves of a sewn shirt before anybody wears it, where their seams go
/// against what front, back and sleeves are: a cap sewn to armholes of both sides, to that of the
/// other side than its name says, to front and back in the wrong order for its side, or with the
/// half that is cut out more, its front, to the back; halves of a sleeve at another piece or side
/// than their names say. Trunks with two armholes only; what is drawn alike on both sides tells
/// nothing.
std::vector<std::string> sleeve_doubts(const Pattern& pattern, const KnownGarment& known);

}  // namespace loosefit::pattern
