#pragma once
#include <vector>

#include "loosefit/dress/lay_round.h"

namespace loosefit::kinds {

/// First positions of a shirt with sleeves round a body [m] (LayRound): front panels pass before
/// the body and back panels behind it, half sleeves over the arms.
std::vector<Vec3> lay_shirt(const garment::Garment& shirt, const body::Body& body,
                            const dress::LayingRoom& room);

}  // namespace loosefit::kinds
