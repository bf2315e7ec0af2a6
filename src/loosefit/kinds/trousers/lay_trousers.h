#pragma once
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/dress/lay_round.h"
#include "loosefit/garment/garment.h"

namespace loosefit::kinds {

/// Trousers as sheets before and behind each leg of a wearer who stands: outseams beside the hips
/// and ankles, inseams between the legs, the crotch seams in the middle plane. A dress::LayRound.
/// \throws GeometryError for a body without waist, hip or crotch level.
std::vector<Vec3> lay_trousers(const garment::Garment& trousers, const body::Body& body,
                               const dress::LayingRoom& room);

}  // namespace loosefit::kinds
