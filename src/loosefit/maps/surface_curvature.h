#pragma once
#include <vector>

#include "loosefit/geometry/closest_point.h"

namespace loosefit::maps {

/// Curvature tensor of a smooth surface at each vertex of its triangulation: κ = ∂n/∂x as a
/// symmetric 3×3 tensor in the tangent plane [1/m], so that tᵀ κ t is the normal curvature along
/// the unit tangent t, positive where the surface is convex (triangles wound outwards). From the
/// quadric that fits the vertices of the two rings round it best over the vertex's tangent plane
/// (Cazals and Pouget 2005, degree 2). The vertices lie on the surface exactly, whatever the
/// triangles between them look like; normals do not, and differences of normals (Rusinkiewicz
/// 2004) or second differences of a sampled distance magnify their errors. Zero where fewer than
/// five neighbours face the same way, and where `wanted`, one entry a vertex, is 0; empty: all are
/// wanted.
std::vector<Mat3> vertex_curvatures(const geometry::TriangleMesh& surface,
                                    const std::vector<char>& wanted = {});

/// Curvature at a point of the surface, linear over its triangle, in the plane across `normal`.
Mat3 curvature_at(const geometry::TriangleMesh& surface, const std::vector<Mat3>& vertex_curvatures,
                  const geometry::ClosestPoint& at, const Vec3& normal);

/// Curvature of the parallel surface at distance d [m] outside: κ/(1 + d κ) per principal
/// direction. Where d comes near the radius of a hollow, the factor stays at 1/kLeastRadiusShare.
Mat3 offset_curvature(const Mat3& curvature, double distance);
inline constexpr double kLeastRadiusShare = 0.2;

}  // namespace loosefit::maps
