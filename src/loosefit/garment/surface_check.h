#pragma once
#include "loosefit/garment/garment.h"

namespace loosefit::garment {

/// The sewn surface must be an oriented manifold with boundary: proper triangles, every edge with
/// at most two triangles that run through it in opposite directions, one fan of triangles per
/// vertex. \throws GeometryError naming the panels involved.
void check_surface(const Garment& garment);

}  // namespace loosefit::garment
