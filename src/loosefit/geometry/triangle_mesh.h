#pragma once
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::geometry {

/// Indexed triangle surface; positions in metres, triangles counter-clockwise seen from outside.
struct TriangleMesh {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
};

/// Unit normal of a triangle; zero for a degenerate one.
Vec3 triangle_normal(const Vec3& a, const Vec3& b, const Vec3& c);
/// Area [m²].
double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c);
/// Area-weighted unit vertex normals; zero where no triangle touches a vertex.
std::vector<Vec3> vertex_normals(const std::vector<Vec3>& vertices,
                                 const std::vector<Triangle>& triangles);
/// Of each triangle the mean of its vertices' normals, of unit length, zero where they cancel: they
/// turn less from one triangle to the next than its own.
std::vector<Vec3> smooth_normals(const TriangleMesh& mesh);
/// Signed volume [m³] of a closed surface, positive when oriented outwards.
double enclosed_volume(const TriangleMesh& mesh);

}  // namespace loosefit::geometry
