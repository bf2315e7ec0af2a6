#pragma once
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::body {

/// Vertices that share an edge with each vertex, ascending.
std::vector<std::vector<int>> neighbours_of(const geometry::TriangleMesh& mesh);

/// Length of the shortest way over the surface to each vertex from the nearest of some vertices
/// [m], by fast marching (Kimmel and Sethian 1998; each triangle is unfolded as in Novotni and
/// Klein 2002); infinite where there is no way. Every vertex but the sources has a neighbour that
/// is nearer.
std::vector<double> surface_distance(const geometry::TriangleMesh& mesh,
                                     const std::vector<int>& sources);

}  // namespace loosefit::body
