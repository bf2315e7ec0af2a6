#pragma once
#include <vector>

#include "loosefit/base/types.h"
#include "loosefit/garment/garment.h"

namespace loosefit::drape {

/// How straight the cloth of a top hangs from its neck to its hem: over the vertices of the hem,
/// the lower quartile of the straight distance at x to that vertex of the neck which is nearest
/// along the cloth, over that way along edges of the flat pieces [–]. Shirts that hang have 0.84 to
/// 0.9, as a way along edges is up to a tenth longer than the shortest; cloth that is gathered on
/// the way has less. 1 where no way leads from one to the other.
double hang_straightness(const garment::Garment& garment, const std::vector<int>& neck,
                         const std::vector<int>& hem, const std::vector<Vec3>& x);

}  // namespace loosefit::drape
