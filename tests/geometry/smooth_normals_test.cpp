#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "loosefit/geometry/triangle_mesh.h"
#include "support/shapes.h"

namespace loosefit::geometry {
namespace {

// Of a ball they are those of the sphere at the middles of its triangles, within a quarter of the
// 7.5° that an edge spans.
TEST(SmoothNormals, OfABallPointOutwards) {
  const TriangleMesh ball = support::sphere(0.5, 24, 48);
  const std::vector<Vec3> normals = smooth_normals(ball);
  ASSERT_EQ(normals.size(), ball.triangles.size());
  double least = 1;
  for (std::size_t t = 0; t < normals.size(); ++t) {
    const auto& [a, b, c] = ball.triangles[t];
    const Vec3 middle = (ball.vertices[std::size_t(a)] + ball.vertices[std::size_t(b)] +
                         ball.vertices[std::size_t(c)])
                            .normalized();
    EXPECT_NEAR(normals[t].norm(), 1, 1e-12);
    least = std::min(least, normals[t].dot(middle));
  }
  EXPECT_GT(least, std::cos(radians(7.5 / 4)));
}

// Two triangles at a right angle: both lean towards the other, by as much as the shared edge has
// of it: its two vertices have the mean normal, the third its own.
TEST(SmoothNormals, OfARightAngleLeanByTheSharedVertices) {
  TriangleMesh angle;
  angle.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
  angle.triangles = {{0, 1, 2}, {0, 3, 1}};
  const std::vector<Vec3> normals = smooth_normals(angle);
  const Vec3 up = Vec3::UnitZ(),
             other = triangle_normal(angle.vertices[0], angle.vertices[3], angle.vertices[1]);
  const Vec3 shared = (up + other).normalized();
  EXPECT_LT((normals[0] - (2 * shared + up).normalized()).norm(), 1e-12);
  EXPECT_LT((normals[1] - (2 * shared + other).normalized()).norm(), 1e-12);
}

}  // namespace
}  // namespace loosefit::geometry
