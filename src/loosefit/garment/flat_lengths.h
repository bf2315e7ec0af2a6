#pragma once
#include <vector>

#include "loosefit/garment/garment.h"
#include "loosefit/geometry/mesh_topology.h"

namespace loosefit::garment {

/// Length of every edge of the garment in the flat pattern [m]; of a seam that on the side of its
/// last triangle. `topology`: of garment.triangles.
std::vector<double> flat_lengths(const Garment& garment, const geometry::MeshTopology& topology);

}  // namespace loosefit::garment
