#pragma once
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/dress/lay_round.h"
#include "loosefit/garment/garment.h"
#include "loosefit/kinds/kind.h"

namespace loosefit::drape {

/// Whether two garments are known to dress different limbs, as a shirt and trousers do. Sheets of
/// one then have no sheets of the other to lie before: laid round the body with more room
/// everywhere it would stand far off the skin even where it is alone.
bool dress_other_limbs(const kinds::GarmentKind& one, const kinds::GarmentKind& other);

/// First positions of a garment that is laid round a wearer who is thicker where others are worn
/// under it. \throws NoRoom when it cuts itself.
std::vector<Vec3> lay_padded(const garment::Garment& garment, const dress::LayRound& lay,
                             const body::PosedBody& wearer);

}  // namespace loosefit::drape
