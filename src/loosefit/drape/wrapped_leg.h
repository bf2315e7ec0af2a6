#pragma once
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/garment/open_seams.h"

namespace loosefit::drape {

/// Panels that are a trouser leg in one piece: sewn to themselves along an inseam from the hem up,
/// which ends below their other end. \param side of each panel: +1 left, −1 right, 0 across the
/// middle, which is none
std::vector<int> find_wrapped_legs(const garment::OpenSeams& open, const std::vector<int>& side);

/// Lays such a panel, which stands upright beside the body with its outside away from it, round
/// the outside of body and leg: its middle beside the leg, its inseam edges before and behind it on
/// its inner side, stretched where it is too narrow. Heights stay.
/// \param side +1 left, −1 right \param x vertices of open.garment [m]
/// \return false, and nothing is moved, where body or panel have no width at some height
bool wrap_leg(const garment::OpenSeams& open, int panel, int side, const body::PosedBody& body,
              std::vector<Vec3>& x);

}  // namespace loosefit::drape
