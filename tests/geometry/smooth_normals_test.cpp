#include <gtest/gtest.h>

#include <algorithm>

#include "loosefit/geometry/triangle_mesh.h"
#include "support/shapes.h"

namespace loosefit::geometry {
namespace {

// Of a ball they are nearer to those of the sphere at the middles of the triangles than the plane
// ones, by a third at least where those are farthest off.
TEST(SmoothNormals, OfABallPointOutwards) {
  const TriangleMesh ball = support::sphere(0.5, 24, 48);
  const std::vector<Vec3> normals = smooth_normals(ball);
  ASSERT_EQ(normals.size(), ball.triangles.size());
  double farthest = 0, farthest_plane = 0;
  for (std::size_t t = 0; t < normals.size(); ++t) {
    const auto& [i, j, k] = ball.triangles[t];
    const Vec3 &a = ball.vertices[std::size_t(i)], &b = ball.vertices[std::size_t(j)],
               &c = ball.vertices[std::size_t(k)];
    const Vec3 outward = (a + b + c).normalized();
    EXPECT_NEAR(normals[t].norm(), 1, 1e-12);
    farthest = std::max(farthest, (normals[t] - outward).norm());
    farthest_plane = std::max(farthest_plane, (triangle_normal(a, b, c) - outward).norm());
  }
  EXPECT_LT(farthest, 2 * farthest_plane / 3);
}

// Two triangles at a right angle, one of twice the area: both lean towards the other, by as much as
// the shared edge has of it. Its two vertices have the mean normal by area, the third its own.
TEST(SmoothNormals, OfARightAngleLeanByTheSharedVertices) {
  TriangleMesh angle;
  angle.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -2}};
  angle.triangles = {{0, 1, 2}, {0, 3, 1}};
  const std::vector<Vec3> normals = smooth_normals(angle);
  const Vec3 up = Vec3::UnitZ(),
             other = triangle_normal(angle.vertices[0], angle.vertices[3], angle.vertices[1]);
  const Vec3 shared = (up + 2 * other).normalized();
  EXPECT_LT((normals[0] - (2 * shared + up).normalized()).norm(), 1e-12);
  EXPECT_LT((normals[1] - (2 * shared + other).normalized()).norm(), 1e-12);
}

}  // namespace
}  // namespace loosefit::geometry
