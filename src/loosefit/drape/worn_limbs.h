#pragma once
#include <vector>

#include "loosefit/drape/limb_lines.h"

namespace loosefit {

/// Which limbs go through each opening of a garment (neck, hem, cuffs), in the order of their first
/// vertices. Two drapes of a garment on one wearer have the same numbers unless a limb has left its
/// sleeve or gone through the cloth, of which a drape that is at rest and cuts nothing may show no
/// other trace. Empty for a body without joints.
std::vector<LimbNumbers> limbs_through_openings(const std::vector<Triangle>& triangles,
                                                const std::vector<Vec3>& x, const Body& body);

}  // namespace loosefit
