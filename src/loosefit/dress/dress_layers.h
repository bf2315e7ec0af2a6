#pragma once
#include <functional>
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/dress/lay_round.h"
#include "loosefit/garment/garment.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::dress {

/// First positions of a garment that is placed by its pattern [m]; \throws as dress_as_placed.
using PlaceOn = std::function<std::vector<Vec3>(
    const garment::Garment&, const pattern::Pattern&, const body::PosedBody&)>;

/// One garment of those that are worn over each other.
struct LayerToDress {
  const garment::Garment* garment = nullptr;
  const pattern::Pattern* pattern = nullptr;  ///< the placement; not needed with `lay`
  LayRound lay = {};                          ///< round the body; empty: as the pattern is placed
  PlaceOn place = {};                         ///< as placed; empty: dress_as_placed
};

/// First positions of garments worn over each other, the innermost first: vertices of all in turn.
/// Each as if alone (lay_round, dress_as_placed), but every one that is laid round the body with
/// more room than the layer under it, so that its sheets pass before and behind those, and its
/// seams beside them. Nothing cuts anything. \throws as the above, and NoRoom when garments cut
/// each other.
std::vector<Vec3> dress_layers(const std::vector<LayerToDress>& layers,
                               const body::PosedBody& body);

}  // namespace loosefit::dress
