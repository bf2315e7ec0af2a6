#pragma once
#include <vector>

#include "loosefit/geometry/closest_point_tree.h"

namespace loosefit::render {

/// The smooth form's places of a skin's vertices [m], kept within the cloth over it: none goes
/// farther outwards or aside than to 3 mm from the cloth, inwards it may go, and where it would lie
/// up to 8 mm outside of cloth that faces its way, as skin does between the corners of coarse
/// cloth, it is pressed 1.5 mm under it. `normals`: of the smooth form; cloth faces outwards.
std::vector<Vec3> clear_of_cloth(const geometry::ClosestPointTree& skin,
                                 const std::vector<Vec3>& smooth, const std::vector<Vec3>& normals,
                                 const geometry::TriangleMesh& cloth);

}  // namespace loosefit::render
