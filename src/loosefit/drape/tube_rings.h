#pragma once
#include <vector>

#include "loosefit/garment/garment.h"

namespace loosefit::drape {

/// Closed curves on the cloth that run round the same tube as an opening: the far rims of ever
/// wider bands of triangles from it, as long as the band is a plain ring that meets no other
/// opening and its rim is not longer than `widest` in the flat pieces [m]. A sleeve that is longer
/// than its arm has the arm in one of them, whatever its cuff hangs round.
std::vector<std::vector<int>> tube_rings(const garment::Garment& garment,
                                         const std::vector<int>& opening, double widest);

}  // namespace loosefit::drape
