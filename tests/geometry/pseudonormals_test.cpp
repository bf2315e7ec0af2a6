#include "loosefit/geometry/pseudonormals.h"

#include <gtest/gtest.h>

#include "loosefit/geometry/closest_point_tree.h"

namespace loosefit::geometry {
namespace {

/// Closed prism of height 1 over a counter-clockwise outline, its caps cut as told.
TriangleMesh prism(const std::vector<Vec3>& outline, const std::vector<Triangle>& caps) {
  const int n = static_cast<int>(outline.size());
  TriangleMesh mesh;
  for (double z : {0.0, 1.0})
    for (const Vec3& p : outline) mesh.vertices.emplace_back(p[0], p[1], z);
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    mesh.triangles.push_back({i, j, j + n});
    mesh.triangles.push_back({i, j + n, i + n});
  }
  for (const Triangle& t : caps) {
    mesh.triangles.push_back({t[0], t[2], t[1]});
    mesh.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  }
  return mesh;
}

/// An L: the square of side 2 without its upper right quarter.
TriangleMesh notched() {
  return prism({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}},
               {{0, 1, 3}, {1, 2, 3}, {0, 3, 5}, {3, 4, 5}});
}

TEST(Pseudonormals, TellInsideNextToEdgesAndCornersThatPointInwards) {
  const TriangleMesh mesh = notched();
  const ClosestPointTree tree(mesh);
  // Nearest is the upright edge of the notch at (1, 1), and its ends.
  EXPECT_NEAR(tree.signed_distance({0.9, 0.9, 0.5}), -std::sqrt(0.02), 1e-15);
  EXPECT_NEAR(tree.signed_distance({1.1, 1.1, 1.1}), std::sqrt(0.02), 1e-15);
  EXPECT_NEAR(tree.signed_distance({0.95, 0.95, 0.9}), -std::sqrt(0.005), 1e-15);
  EXPECT_NEAR(tree.signed_distance({1.05, 1.05, 0.5}), 0.05, 1e-15);
}

TEST(Pseudonormals, TellOutsideNextToANeedle) {
  // Seen from beyond the tip of a needle some of its faces look like the inside.
  const double w = 0.05;
  TriangleMesh needle;
  needle.vertices = {{0, 0, 0}, {1, w, 0}, {1, -w, 0}, {1, 0, w}};
  needle.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  const ClosestPointTree tree(needle);
  for (const Vec3& p : {Vec3(-0.1, 0, 0.09), Vec3(-0.1, 0.09, 0), Vec3(-0.1, -0.09, 0),
                        Vec3(-0.1, 0, -0.09), Vec3(-0.01, 0, 0)})
    EXPECT_NEAR(tree.signed_distance(p), p.norm(), 1e-15);
  EXPECT_LT(tree.signed_distance({0.9, 0, 0.01}), 0);
}

TEST(Pseudonormals, OfAnEdgeIsTheSumOfItsTwoFaces) {
  const TriangleMesh mesh = notched();
  const Pseudonormals sides(mesh);
  const auto face = [&](const Triangle& t) {
    return triangle_normal(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
  };
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i)
    for (int k = 0; k < 3; ++k) {
      const Triangle& t = mesh.triangles[i];
      const int from = t[k], to = t[(k + 1) % 3];
      Vec3 sum = face(t);
      for (const Triangle& other : mesh.triangles)
        for (int j = 0; j < 3; ++j)
          if (other[j] == to && other[(j + 1) % 3] == from) sum += face(other);
      ClosestPoint middle;
      middle.triangle = i;
      middle.barycentric[k] = middle.barycentric[(k + 1) % 3] = 0.5;
      EXPECT_LT((sides.at(mesh, middle) - sum).norm(), 1e-14) << "triangle " << i << " edge " << k;
    }
}

}  // namespace
}  // namespace loosefit::geometry
