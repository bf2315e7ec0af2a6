#pragma once
#include <vector>

#include "loosefit/dress/lay_round.h"

namespace loosefit {

/// First positions of a shirt with sleeves round a body [m] (LayRound): front panels pass before
/// the body and back panels behind it, half sleeves over the arms.
std::vector<Vec3> lay_shirt(const Garment& shirt, const Body& body, const LayingRoom& room);

}  // namespace loosefit
