#include "loosefit/geometry/triangle_mesh.h"

#include <Eigen/Geometry>

namespace loosefit::geometry {

Vec3 triangle_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = (b - a).cross(c - a);
  const double length = n.norm();
  return length > 0 ? Vec3(n / length) : Vec3(Vec3::Zero());
}

double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * (b - a).cross(c - a).norm();
}

std::vector<Vec3> vertex_normals(const std::vector<Vec3>& vertices,
                                 const std::vector<Triangle>& triangles) {
  std::vector<Vec3> normals(vertices.size(), Vec3::Zero());
  for (const Triangle& t : triangles) {
    const Vec3 n = (vertices[t[1]] - vertices[t[0]]).cross(vertices[t[2]] - vertices[t[0]]);
    for (int corner : t) normals[corner] += n;
  }
  for (Vec3& n : normals) {
    const double length = n.norm();
    if (length > 0) n /= length;
  }
  return normals;
}

std::vector<Vec3> smooth_normals(const TriangleMesh& mesh) {
  const std::vector<Vec3> of_vertex = vertex_normals(mesh.vertices, mesh.triangles);
  std::vector<Vec3> normals;
  normals.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles)
    normals.push_back(
        (of_vertex[std::size_t(a)] + of_vertex[std::size_t(b)] + of_vertex[std::size_t(c)])
            .normalized());
  return normals;
}

double enclosed_volume(const TriangleMesh& mesh) {
  double volume = 0;
  for (const Triangle& t : mesh.triangles)
    volume += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]]));
  return volume / 6.0;
}

}  // namespace loosefit::geometry
