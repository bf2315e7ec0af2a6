#pragma once
#include <array>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::geometry {

/// Corners of a triangle in the flat pattern [m].
using FlatCorners = std::array<Vec2, 3>;

/// u × v = u_x v_y − u_y v_x: twice the signed area of the triangle that they span, positive when v
/// lies counter-clockwise of u.
inline double cross(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

/// Area of a flat triangle [m²], whichever way round.
double flat_area(const FlatCorners& flat);
std::vector<double> flat_areas(const std::vector<FlatCorners>& flat);
/// Least height of all triangles [m]; at most 1e9.
double shortest_height(const std::vector<FlatCorners>& flat);

/// F = ∂x/∂(u, v) of a triangle, constant over it: its columns are the images of a unit step along
/// u and along v.
using DeformationGradient = Eigen::Matrix<double, 3, 2>;

/// F = [x1 − x0, x2 − x0] [u1 − u0, u2 − u0]⁻¹. NaN for a flat triangle without area.
DeformationGradient deformation_gradient(const FlatCorners& flat, const Triangle& corner,
                                         const std::vector<Vec3>& positions);

}  // namespace loosefit::geometry
