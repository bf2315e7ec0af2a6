#pragma once
#include <utility>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::geometry {

/// Angle between the two half-planes at an edge below which a surface counts as folded flat on
/// itself there [rad]: 0.25°. The free corners of triangles with edges of 5 to 15 mm then are less
/// than 0.02 to 0.06 mm from the other triangle, nearer than two layers of any fabric can lie. A
/// sharp crease whose layers rest on each other stays above it: contact of cloth with cloth holds
/// the free corners off by a good part of the thickness.
inline constexpr double kFoldedAngle = 0.00436332312998582;

/// Pairs (i, j), i < j, of triangles that share an edge and lie on the same side of it, at less
/// than `angle` to each other: what the test for intersections leaves out. Triangles without area
/// are not judged.
std::vector<std::pair<int, int>> folded_edges(const std::vector<Vec3>& vertices,
                                              const std::vector<Triangle>& triangles,
                                              double angle = kFoldedAngle);

}  // namespace loosefit::geometry
