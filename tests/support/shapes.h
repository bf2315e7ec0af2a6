#pragma once
#include <cmath>
#include <random>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::support {

/// Closed, outward oriented latitude-longitude sphere about the origin.
inline geometry::TriangleMesh sphere(double radius, int rings, int sectors) {
  geometry::TriangleMesh mesh;
  mesh.vertices.emplace_back(0, 0, radius);
  for (int i = 1; i < rings; ++i)
    for (int j = 0; j < sectors; ++j) {
      const double theta = kPi * i / rings, phi = 2 * kPi * j / sectors;
      mesh.vertices.emplace_back(radius * std::sin(theta) * std::cos(phi),
                                 radius * std::sin(theta) * std::sin(phi),
                                 radius * std::cos(theta));
    }
  mesh.vertices.emplace_back(0, 0, -radius);
  const int last = static_cast<int>(mesh.vertices.size()) - 1;
  const auto at = [&](int i, int j) { return 1 + (i - 1) * sectors + j % sectors; };
  for (int j = 0; j < sectors; ++j) {
    mesh.triangles.push_back({0, at(1, j), at(1, j + 1)});
    mesh.triangles.push_back({last, at(rings - 1, j + 1), at(rings - 1, j)});
    for (int i = 1; i + 1 < rings; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

/// Closed, outward oriented circular cylinder along z, from z0 to z1.
inline geometry::TriangleMesh cylinder(double radius, double z0, double z1, int rows, int sectors) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i <= rows; ++i)
    for (int j = 0; j < sectors; ++j) {
      const double phi = 2 * kPi * j / sectors;
      mesh.vertices.emplace_back(radius * std::cos(phi), radius * std::sin(phi),
                                 z0 + (z1 - z0) * i / rows);
    }
  const int bottom = static_cast<int>(mesh.vertices.size()), top = bottom + 1;
  mesh.vertices.emplace_back(0, 0, z0);
  mesh.vertices.emplace_back(0, 0, z1);
  const auto at = [&](int i, int j) { return i * sectors + j % sectors; };
  for (int j = 0; j < sectors; ++j) {
    for (int i = 0; i < rows; ++i) {
      mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
    mesh.triangles.push_back({bottom, at(0, j + 1), at(0, j)});
    mesh.triangles.push_back({top, at(rows, j), at(rows, j + 1)});
  }
  return mesh;
}

/// Flat sheet [0, width] x [0, height] in the (x, y) plane with near-equilateral, optionally
/// jittered triangles: rows of points shifted by half an edge.
inline geometry::TriangleMesh sheet(double width, double height, double edge, double jitter = 0,
                                    unsigned seed = 1) {
  geometry::TriangleMesh mesh;
  const int columns = std::max(1, static_cast<int>(std::round(width / edge)));
  const int rows = std::max(1, static_cast<int>(std::round(height / (edge * std::sqrt(0.75)))));
  std::mt19937 rng(seed);
  std::uniform_real_distribution<double> shake(-jitter * edge, jitter * edge);
  std::vector<std::vector<int>> index(rows + 1);
  for (int i = 0; i <= rows; ++i) {
    const double y = height * i / rows;
    std::vector<double> xs;
    for (int j = 0; j <= columns; ++j) {
      if (i % 2 == 0) {
        xs.push_back(width * j / columns);
      } else {
        if (j == 0) xs.push_back(0);
        if (j < columns) xs.push_back(width * (j + 0.5) / columns);
        if (j == columns) xs.push_back(width);
      }
    }
    for (std::size_t j = 0; j < xs.size(); ++j) {
      Vec3 p(xs[j], y, 0);
      if (j > 0 && j + 1 < xs.size() && i > 0 && i < rows) p += Vec3(shake(rng), shake(rng), 0);
      index[i].push_back(static_cast<int>(mesh.vertices.size()));
      mesh.vertices.push_back(p);
    }
  }
  for (int i = 0; i < rows; ++i) {
    const auto &a = index[i], &b = index[i + 1];
    std::size_t p = 0, q = 0;  // zip the two rows together, advancing the one that lags
    while (p + 1 < a.size() || q + 1 < b.size()) {
      const bool step_a = q + 1 >= b.size() || (p + 1 < a.size() && mesh.vertices[a[p + 1]][0] <=
                                                                        mesh.vertices[b[q + 1]][0]);
      if (step_a) {
        mesh.triangles.push_back({a[p], a[p + 1], b[q]});
        ++p;
      } else {
        mesh.triangles.push_back({a[p], b[q + 1], b[q]});
        ++q;
      }
    }
  }
  return mesh;
}

}  // namespace loosefit::support
