#pragma once
#include <array>
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::drape {

/// Vertices of a mesh level on the surface of the coarser one: midpoints of its edges, and the
/// vertices kept. `parents` as in GarmentHierarchy.
std::vector<Vec3> on_coarse_surface(const std::vector<std::array<int, 2>>& parents,
                                    const std::vector<Vec3>& coarse);

/// What sets the shape `fine` of a mesh apart from its shape `before` [m], turned at each vertex as
/// its surroundings turned from `before` to `now` (nearest rotation of the triangles round it,
/// Kabsch 1976): added to `now` it carries folds that a coarser mesh cannot show to where that mesh
/// has gone.
std::vector<Vec3> turned_detail(const std::vector<Triangle>& triangles,
                                const std::vector<Vec3>& before, const std::vector<Vec3>& fine,
                                const std::vector<Vec3>& now);

}  // namespace loosefit::drape
