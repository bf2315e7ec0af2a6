#pragma once
#include <cstdint>
#include <string>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::support {

template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A binary little-endian PLY with double coordinates.
inline std::string ply_bytes(const geometry::TriangleMesh& mesh) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string(mesh.vertices.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                      std::to_string(mesh.triangles.size()) +
                      "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& p : mesh.vertices)
    for (int axis = 0; axis < 3; ++axis) append(bytes, p[axis]);
  for (const Triangle& t : mesh.triangles) {
    append(bytes, std::uint8_t(3));
    for (const int corner : t) append(bytes, std::int32_t(corner));
  }
  return bytes;
}

/// A binary STL.
inline std::string stl_bytes(const geometry::TriangleMesh& mesh) {
  std::string bytes(80, ' ');
  append(bytes, std::uint32_t(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    for (const Vec3& p : {geometry::triangle_normal(a, b, c), a, b, c})
      for (int axis = 0; axis < 3; ++axis) append(bytes, float(p[axis]));
    append(bytes, std::uint16_t(0));
  }
  return bytes;
}

}  // namespace loosefit::support
