#pragma once
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/garment/garment.h"

namespace loosefit::dress {

/// Length of an edge on the flat pieces [m].
double flat_length(const garment::Garment& garment, const garment::Garment::EdgeChain& chain);

/// Where a front neckline of this flat length is laid, seen from the front, between two points of
/// the (x, z) plane [m]: straight across or, where that would lie before the chin or above it, a
/// parabola that hangs below it, but not lower than its length allows.
std::vector<Vec2> front_neckline(double length, const body::Body& body, const Vec2& from,
                                 const Vec2& to);

}  // namespace loosefit::dress
