#pragma once
#include <functional>
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/dress/lay_round.h"
#include "loosefit/garment/garment.h"

namespace loosefit::dress {

/// First positions of a garment that is placed by its pattern [m].
using PlaceOn = std::function<std::vector<Vec3>(const body::PosedBody&)>;

/// One garment of those that are worn over each other.
struct LayerToDress {
  const garment::Garment* garment = nullptr;
  LayRound lay = {};   ///< round the body; empty: `place`
  PlaceOn place = {};  ///< not needed with `lay`
};

/// First positions of garments worn over each other, the innermost first: vertices of all in turn.
/// Each as if alone (lay_round, LayerToDress::place), but every one that is laid round the body
/// with more room than the layer under it, so that its sheets pass before and behind those, and its
/// seams beside them; one that is placed goes round a wearer who is thicker by what lies under it,
/// there only. Nothing cuts anything. \throws as the above, and NoRoom when garments that are laid
/// round the body cut each other, GarmentsCut when placed ones do.
std::vector<Vec3> dress_layers(const std::vector<LayerToDress>& layers,
                               const body::PosedBody& body);

}  // namespace loosefit::dress
