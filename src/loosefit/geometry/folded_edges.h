#pragma once
#include <utility>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::geometry {

/// Angle between the two half-planes at an edge below which a surface may be folded flat on itself
/// there [rad]: 0.25°.
inline constexpr double kFoldedAngle = 0.00436332312998582;

/// Distance of the free corners from the other triangle below which it is [m]: a ninth of the
/// thinnest fabric, nearer than two layers of any can lie, and 0.25° for triangles 5 mm high. By
/// the angle alone large triangles would be judged by more: two layers of a shirting pressed to
/// 0.05 mm pass on a mesh of 10 mm and would not on one of 20 mm. Contact of cloth with cloth holds
/// the free corners of a sharp crease off by a good part of the thickness.
inline constexpr double kFoldedDistance = 2e-5;

/// Pairs (i, j), i < j, of triangles that share an edge and lie on the same side of it, at less
/// than kFoldedAngle to each other and with both free corners nearer than kFoldedDistance to the
/// other's plane: what the test for intersections leaves out. Triangles without area are not
/// judged.
std::vector<std::pair<int, int>> folded_edges(const std::vector<Vec3>& vertices,
                                              const std::vector<Triangle>& triangles);

}  // namespace loosefit::geometry
