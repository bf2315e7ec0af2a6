#pragma once
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::render {

/// A closed smooth solid in place of a detailed one, as an egg for a head or a mitten for a hand:
/// the convex hull of `points`, star-shaped about its middle, with its radius low-pass filtered
/// over the directions in `rounds` rounds (each by about 4°). It is cut back to 3 mm inside of what
/// cloth is seen from its middle. Empty for points in a plane.
geometry::TriangleMesh smooth_solid(const std::vector<Vec3>& points,
                                    const geometry::TriangleMesh& cloth, int rounds);

}  // namespace loosefit::render
