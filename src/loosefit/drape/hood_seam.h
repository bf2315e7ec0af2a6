#pragma once
#include <vector>

#include "loosefit/drape/openings.h"
#include "loosefit/garment/garment.h"

namespace loosefit::drape {

/// Where the pieces along the rim of an opening are sewn to the rest, when they reach no other
/// opening: the neckline of a hood or collar. Its vertices in order, an open curve where the seam
/// is open; empty when there is no such seam, or more than one.
std::vector<int> hood_seam(const garment::Garment& garment, const std::vector<Opening>& openings,
                           const Opening& opening);

}  // namespace loosefit::drape
