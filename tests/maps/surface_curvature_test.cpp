#include "loosefit/maps/surface_curvature.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>
#include <random>

#include "support/shapes.h"

namespace loosefit::maps {
namespace {

/// A surface of points p(a, b) on an n × m grid closed in both directions, triangles outwards.
geometry::TriangleMesh closed_grid(int n, int m, const std::function<Vec3(double, double)>& p,
                                   double jitter = 0) {
  geometry::TriangleMesh mesh;
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> shake(-jitter, jitter);
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i)
      mesh.vertices.push_back(p(2 * kPi * (i + shake(rng)) / n, 2 * kPi * (j + shake(rng)) / m));
  const auto id = [&](int i, int j) { return j % m * n + i % n; };
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  return mesh;
}

double along(const Mat3& curvature, const Vec3& direction) {
  return direction.dot(curvature * direction);
}

TEST(SurfaceCurvature, OfASphereIsOneOverTheRadiusInEveryDirection) {
  const geometry::TriangleMesh ball = support::sphere(0.08, 40, 80);
  const auto curvature = vertex_curvatures(ball);
  for (std::size_t v = 0; v < curvature.size(); ++v) {
    const Vec3 n = ball.vertices[v].normalized();
    if (std::abs(n.z()) > 0.9) continue;  // slivers round the poles
    const Vec3 east = Vec3(-n.y(), n.x(), 0).normalized(), north = n.cross(east);
    EXPECT_NEAR(along(curvature[v], east), 12.5, 0.01 * 12.5);
    EXPECT_NEAR(along(curvature[v], north), 12.5, 0.01 * 12.5);
    EXPECT_NEAR(along(curvature[v], (east + north).normalized()), 12.5, 0.01 * 12.5);
    EXPECT_NEAR((curvature[v] * n).norm(), 0, 0.2);
  }
}

TEST(SurfaceCurvature, OfACylinderIsHoopOnly) {
  const geometry::TriangleMesh tube = support::cylinder(0.05, 0, 0.3, 30, 100);
  const auto curvature = vertex_curvatures(tube);
  for (std::size_t v = 0; v < curvature.size(); ++v) {
    if (tube.vertices[v].z() < 0.02 || tube.vertices[v].z() > 0.28) continue;
    const Vec3 hoop = Vec3(-tube.vertices[v].y(), tube.vertices[v].x(), 0).normalized();
    EXPECT_NEAR(along(curvature[v], hoop), 20, 0.1);
    EXPECT_NEAR(along(curvature[v], Vec3::UnitZ()), 0, 0.01);
    EXPECT_NEAR(hoop.dot(curvature[v].col(2)), 0, 0.05);
  }
}

// docs/theory/validation.md 6.2: κ = a/b² at the ends of the long axis, b/a² at those of the short
// one.
TEST(SurfaceCurvature, OfAnEllipticCylinderRunsFromBOverASquaredToAOverBSquared) {
  constexpr double a = 0.16, b = 0.1, round = 0.6;  // a torus with an elliptic section, wide open
  for (double jitter : {0.0, 0.3}) {
    const geometry::TriangleMesh ring = closed_grid(
        400, 200,
        [&](double u, double v) {
          const double r = round + a * std::cos(v);
          return Vec3(r * std::cos(u), r * std::sin(u), b * std::sin(v));
        },
        jitter);
    const auto curvature = vertex_curvatures(ring);
    double error = 0, scatter = 0;
    int count = 0;
    for (std::size_t i = 0; i < ring.vertices.size(); ++i) {
      const Vec3& p = ring.vertices[i];
      const Vec3 radial = Vec3(p.x(), p.y(), 0).normalized(), hoop = Vec3::UnitZ().cross(radial);
      const double c = (p.head<2>().norm() - round) / a, s = p.z() / b;
      const double speed = std::sqrt(a * a * s * s + b * b * c * c);
      const Vec3 section = (-a * s * radial + b * c * Vec3::UnitZ()).normalized();
      const double in_section = a * b / (speed * speed * speed);
      // Normal curvature along the ring: radial part of the normal over the distance to the axis.
      const double round_ring = b * c / speed / p.head<2>().norm();
      const double d = along(curvature[i], section) - in_section;
      EXPECT_NEAR(along(curvature[i], section), in_section, 0.04 * in_section) << jitter;
      EXPECT_NEAR(along(curvature[i], hoop), round_ring, 0.15) << jitter;
      error += d;
      scatter += d * d;
      ++count;
    }
    EXPECT_NEAR(error / count, 0, 0.05) << jitter;
    EXPECT_LT(std::sqrt(scatter / count), 0.15) << jitter;  // of 3.9 … 16 per metre
  }
}

TEST(SurfaceCurvature, OfASaddleHasBothSigns) {
  constexpr double big = 0.2, small = 0.05;
  const geometry::TriangleMesh torus = closed_grid(160, 60, [&](double u, double v) {
    const double r = big + small * std::cos(v);
    return Vec3(r * std::cos(u), r * std::sin(u), small * std::sin(v));
  });
  const auto curvature = vertex_curvatures(torus);
  const int inner = 30 * 160;  // v = π, u = 0: the waist of the hole
  EXPECT_NEAR(torus.vertices[inner].x(), big - small, 1e-9);
  EXPECT_NEAR(along(curvature[inner], Vec3::UnitZ()), 1 / small, 0.02 / small);
  EXPECT_NEAR(along(curvature[inner], Vec3::UnitY()), -1 / (big - small), 0.02 / (big - small));
}

TEST(SurfaceCurvature, OfAParallelSurfaceIsThatOfTheLargerRadius) {
  Mat3 k = Mat3::Zero();
  k(0, 0) = 20;
  k(1, 1) = -5;
  const Mat3 out = offset_curvature(k, 0.01);
  EXPECT_NEAR(out(0, 0), 1 / (0.05 + 0.01), 1e-9);
  EXPECT_NEAR(out(1, 1), -1 / (0.2 - 0.01), 1e-9);
  EXPECT_NEAR(out(2, 2), 0, 1e-12);
  EXPECT_NEAR(offset_curvature(k, 0.3)(1, 1), -5 / kLeastRadiusShare, 1e-9);  // past the centre
}

TEST(SurfaceCurvature, BetweenVerticesIsLinearAndInTheTangentPlane) {
  const geometry::TriangleMesh ball = support::sphere(0.1, 30, 60);
  const auto curvature = vertex_curvatures(ball);
  geometry::ClosestPoint at;
  at.triangle = 1700;
  at.barycentric = Vec3(0.2, 0.3, 0.5);
  Vec3 normal = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
    normal += at.barycentric[k] * ball.vertices[ball.triangles[1700][k]].normalized();
  normal.normalize();
  const Mat3 between = curvature_at(ball, curvature, at, normal);
  EXPECT_NEAR((between * normal).norm(), 0, 1e-12);
  EXPECT_NEAR(between.trace(), 20, 0.2);
}

}  // namespace
}  // namespace loosefit::maps
