#pragma once
#include <array>
#include <vector>

#include "loosefit/garment/garment.h"

// The hem of an upper garment on its wearer, for the gates of garments on people.
namespace loosefit::validate {

/// Vertices of the hem in order: the lowest border of the garment that is longer than 0.6 m, which
/// no cuff is. `x`: positions [m], upright, z up. Empty where there is none.
std::vector<int> trunk_hem(const garment::Garment& mesh, const std::vector<Vec3>& x);

/// Where to look at a hem: within 25° to either side, seen from the middle of the hem.
enum HemPlace { hem_right, hem_front, hem_back, hem_left, kHemPlaces };
using HemHeights = std::array<double, kHemPlaces>;

/// Mean of `value` over the vertices of the hem at each place. `x`: positions [m] that tell the
/// places, the wearer looking along −y. `value`: of every vertex. \throws SolverFailure where a
/// place has no hem.
HemHeights hem_means(const std::vector<int>& hem, const std::vector<Vec3>& x,
                     const std::vector<double>& value);

}  // namespace loosefit::validate
