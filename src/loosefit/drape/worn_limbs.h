#pragma once
#include <vector>

#include "loosefit/body/body.h"

namespace loosefit {

/// How often the wearer's trunk and arms go through each opening of a garment (neck, hem, cuffs):
/// signed crossings of the lines through the joints with the disc that an opening spans, opening by
/// opening in the order of their first vertices, trunk, left and right arm of each. Two drapes of a
/// garment on one wearer have the same numbers unless a limb has left its sleeve or gone through
/// the cloth, of which a drape that is at rest and cuts nothing may show no other trace. Empty for
/// a body without joints.
std::vector<int> limbs_through_openings(const std::vector<Triangle>& triangles,
                                        const std::vector<Vec3>& x, const Body& body);

}  // namespace loosefit
