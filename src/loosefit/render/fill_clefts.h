#pragma once
#include <vector>

#include "loosefit/body/body.h"

namespace loosefit::render {

/// Places of a body's vertices [m] on a surface of the same triangles with every section across the
/// trunk brought to its convex hull, from where the legs part to the armpits: as a tape or a dress
/// form bridges the clefts between breasts and buttocks and along the spine. Fades out towards both
/// ends. The surface as it is where joints of hips or neck are not known.
std::vector<Vec3> fill_clefts(const body::Body& body, const geometry::TriangleMesh& surface);

}  // namespace loosefit::render
