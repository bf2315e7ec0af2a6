#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/geometry/path_graph.h"
#include "loosefit/geometry/straighten_path.h"

namespace loosefit::geometry {
namespace {

/// A sheet of columns × rows squares cut in two, bent by `place(u, v)`; inner vertices are shaken
/// by a quarter of a square, so that no line of the mesh is straight.
TriangleMesh sheet(int columns, int rows, double width, double height,
                   const std::function<Vec3(double, double)>& place, bool closed = false) {
  std::mt19937 rng(7);
  std::uniform_real_distribution<double> shake(-0.25, 0.25);
  TriangleMesh mesh;
  const int across = closed ? columns : columns + 1;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i < across; ++i) {
      const bool inner = (closed || (i > 0 && i < columns)) && j > 0 && j < rows;
      const double du = inner ? shake(rng) : 0, dv = inner ? shake(rng) : 0;
      mesh.vertices.push_back(place(width * (i + du) / columns, height * (j + dv) / rows));
    }
  const auto id = [&](int i, int j) { return j * across + (closed ? i % columns : i); };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  return mesh;
}

SurfacePoint at(const TriangleMesh& mesh, const Vec3& place) {
  const ClosestPoint found = ClosestPointTree(mesh).query(place);
  return {found.triangle, found.barycentric};
}

SurfacePath shortest(const PathSurface& surface, const SurfacePoint& from, const SurfacePoint& to) {
  const auto path = cheapest_path(surface, from, to,
                                  [&](const PathPiece& piece) { return surface.length(piece); });
  EXPECT_TRUE(path.has_value());
  return path ? straighten_path(surface, *path) : SurfacePath{};
}

Vec3 in_space(const TriangleMesh& mesh, int triangle, const Vec3& w) {
  const Triangle& t = mesh.triangles[triangle];
  return w[0] * mesh.vertices[t[0]] + w[1] * mesh.vertices[t[1]] + w[2] * mesh.vertices[t[2]];
}

void expect_in_one_piece(const TriangleMesh& mesh, const SurfacePath& path) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    EXPECT_LT((in_space(mesh, path[i].triangle, path[i].to) -
               in_space(mesh, path[i + 1].triangle, path[i + 1].from))
                  .norm(),
              1e-9);
}

TEST(SurfacePaths, AreStraightInThePlane) {
  const TriangleMesh mesh =
      sheet(23, 17, 0.4, 0.3, [](double u, double v) { return Vec3(u, v, 0); });
  const PathSurface surface(mesh);
  const Vec3 ends[][2] = {{{0.013, 0.021, 0}, {0.377, 0.268, 0}},
                          {{0.02, 0.28, 0}, {0.39, 0.02, 0}},
                          {{0.2, 0.01, 0}, {0.2, 0.29, 0}},
                          {{0.101, 0.1, 0}, {0.102, 0.1, 0}}};
  for (const auto& [from, to] : ends) {
    const SurfacePath path = shortest(surface, at(mesh, from), at(mesh, to));
    EXPECT_NEAR(surface.length(path), (to - from).norm(), 1e-7);
    expect_in_one_piece(mesh, path);
    for (const PathPiece& piece : path) {
      const Vec3 p = in_space(mesh, piece.triangle, piece.to) - from,
                 way = (to - from).normalized();
      EXPECT_LT((p - way * way.dot(p)).norm(), 1e-7);
    }
  }
}

TEST(SurfacePaths, AreHelicesOnACylinder) {
  // Flat facets: the geodesic of the prism is straight when its facets are unrolled.
  constexpr double kRadius = 0.05, kHeight = 0.3;
  constexpr int kAround = 40;
  const double facet = 2 * kRadius * std::sin(kPi / kAround), girth = kAround * facet;
  const TriangleMesh mesh = sheet(
      kAround, 30, girth, kHeight,
      [&](double u, double v) {
        // On the facet that u falls on.
        const double i = std::floor(u / facet + 1e-12), share = u / facet - i;
        const double a = 2 * kPi * i / kAround, b = 2 * kPi * (i + 1) / kAround;
        return Vec3(kRadius * ((1 - share) * std::cos(a) + share * std::cos(b)),
                    kRadius * ((1 - share) * std::sin(a) + share * std::sin(b)), v);
      },
      true);
  // Shaken vertices lie on the facets, triangles across an edge of the prism do not: compare with
  // the unrolled one within what they cut off.
  const PathSurface surface(mesh);
  const auto on = [&](double angle, double z) {
    return at(mesh, Vec3(kRadius * std::cos(angle), kRadius * std::sin(angle), z));
  };
  for (const double turn : {0.5, 1.5, 2.5}) {
    const double length = surface.length(shortest(surface, on(0.3, 0.05), on(0.3 + turn, 0.25)));
    const double helix = std::hypot(kRadius * turn, 0.2);
    EXPECT_NEAR(length, helix, 0.003 * helix) << turn;
  }
  // More than half way round the other way is shorter.
  const double other = surface.length(shortest(surface, on(0, 0.1), on(4.5, 0.2)));
  EXPECT_NEAR(other, std::hypot(kRadius * (2 * kPi - 4.5), 0.1), 0.003 * other);
}

/// Flat fan of a cone: n triangles of `angle` at the tip, sides of length 1.
TriangleMesh cone_fan(int n, double angle) {
  // Only lengths matter: a pyramid with n sides whose tip angles are `angle`.
  const double chord = 2 * std::sin(angle / 2), radius = chord / (2 * std::sin(kPi / n));
  TriangleMesh mesh;
  mesh.vertices.push_back({0, 0, std::sqrt(1 - radius * radius)});
  for (int i = 0; i < n; ++i)
    mesh.vertices.emplace_back(radius * std::cos(2 * kPi * i / n),
                               radius * std::sin(2 * kPi * i / n), 0);
  for (int i = 0; i < n; ++i) mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  return mesh;
}

TEST(SurfacePaths, GoRoundTheTipOfAConeOnTheSideThatIsShorter) {
  // Total angle 8 × 30° = 240°: from a place half way down, over an angle φ of the unrolled cone,
  // the chord; never over the tip.
  const double tip = radians(30);
  const TriangleMesh mesh = cone_fan(8, tip);
  const PathSurface surface(mesh);
  const auto on = [&](int triangle, double share) {
    // Middle of the side of a triangle, a `share` down.
    return SurfacePoint{triangle, Vec3(1 - share, share / 2, share / 2)};
  };
  const double r = 0.6 * std::cos(tip / 2);
  for (int t = 1; t < 8; ++t) {
    const double phi = tip * std::min(t, 8 - t);
    EXPECT_NEAR(surface.length(shortest(surface, on(0, 0.6), on(t, 0.6))),
                2 * r * std::sin(phi / 2), 1e-6)
        << t;
  }
}

TEST(SurfacePaths, PullTautFromAWayAroundTheWrongSide) {
  // Starts from a path that goes the long way round the tip, over 240° of 300°: it bends there, and
  // only turning round it makes it straight.
  const double tip = radians(30);
  const TriangleMesh mesh = cone_fan(10, tip);
  const PathSurface surface(mesh);
  const SurfacePoint from{0, Vec3(0.4, 0.3, 0.3)}, to{2, Vec3(0.4, 0.3, 0.3)};
  SurfacePath path;
  Vec3 here = from.barycentric;
  for (int t = 10; t > 2; --t) {  // 0, 9, 8, …
    path.push_back({t % 10, here, Vec3(0.5, 0.5, 0)});
    here = Vec3(0.5, 0, 0.5);
  }
  path.push_back({2, here, to.barycentric});
  const double r = 0.6 * std::cos(tip / 2);
  EXPECT_NEAR(surface.length(straighten_path(surface, path)), 2 * r * std::sin(tip), 1e-6);
}

TEST(SurfacePaths, BendOnlyAtTheBorderOfAHole) {
  // A square hole of 0.1 in the middle of a plane, its corners in the way.
  TriangleMesh mesh = sheet(30, 30, 0.3, 0.3, [](double u, double v) { return Vec3(u, v, 0); });
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    const Vec3 c = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3;
    return std::abs(c.x() - 0.15) < 0.05 && std::abs(c.y() - 0.15) < 0.05;
  });
  // The border is as the shaken vertices have it: its taut string by brute force over its corners.
  const PathSurface surface(mesh);
  const Vec3 from(0.02, 0.14, 0), to(0.28, 0.15, 0);
  const SurfacePath path = shortest(surface, at(mesh, from), at(mesh, to));
  std::vector<Vec3> rim;
  for (const auto& loop : surface.topology().boundary_loops())
    for (const int v : loop) {
      const Vec3& p = mesh.vertices[v];
      if (std::abs(p.x() - 0.15) < 0.1 && std::abs(p.y() - 0.15) < 0.1) rim.push_back(p);
    }
  // Convex hull of the rim's lower half with both ends: the taut string below the hole.
  double best = 1;
  for (const double side : {-1.0, 1.0}) {
    std::vector<Vec3> points = {from, to};
    for (const Vec3& p : rim) points.push_back(p);
    std::sort(points.begin(), points.end(),
              [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); });
    std::vector<Vec3> hull;
    for (const Vec3& p : points) {
      while (hull.size() >= 2 &&
             side * (hull.back() - hull[hull.size() - 2]).cross(p - hull[hull.size() - 2]).z() >= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    double length = 0;
    for (std::size_t i = 0; i + 1 < hull.size(); ++i) length += (hull[i + 1] - hull[i]).norm();
    best = std::min(best, length);
  }
  EXPECT_NEAR(surface.length(path), best, 1e-6);
}

TEST(SurfacePaths, RefractAsSnellSays) {
  // Right half of the plane costs twice as much per metre: sin a = 2 sin b at the line between.
  const TriangleMesh mesh = sheet(40, 30, 0.4, 0.3, [](double u, double v) {
    return Vec3(std::abs(u - 0.2) < 0.0051 ? 0.2 : u, v, 0);
  });
  const PathSurface surface(mesh);
  const auto price = [&](int t) {
    const Triangle& v = mesh.triangles[t];
    return (mesh.vertices[v[0]].x() + mesh.vertices[v[1]].x() + mesh.vertices[v[2]].x()) / 3 > 0.2
               ? 2.0
               : 1.0;
  };
  const auto cost = [&](const PathPiece& p) { return price(p.triangle) * surface.length(p); };
  const Vec3 from(0.05, 0.05, 0), to(0.35, 0.25, 0);
  const auto coarse = cheapest_path(surface, at(mesh, from), at(mesh, to), cost, {}, 5);
  ASSERT_TRUE(coarse.has_value());
  const SurfacePath path = refine_crossings(surface, *coarse, cost);
  double paid = 0;
  for (const PathPiece& piece : path) paid += cost(piece);
  double best = 1;
  for (double y = 0.05; y < 0.25; y += 1e-5)
    best = std::min(best, std::hypot(0.15, y - 0.05) + 2 * std::hypot(0.15, 0.25 - y));
  EXPECT_NEAR(paid, best, 1e-3 * best);
  EXPECT_GE(paid, best - 1e-9);
}

TEST(SurfacePaths, FindNoneBetweenTwoPiecesOfASurface) {
  TriangleMesh mesh = sheet(10, 10, 0.1, 0.1, [](double u, double v) { return Vec3(u, v, 0); });
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::abs((mesh.vertices[t[0]].x() + mesh.vertices[t[1]].x() + mesh.vertices[t[2]].x()) /
                        3 -
                    0.05) < 0.012;
  });
  const PathSurface surface(mesh);
  EXPECT_FALSE(cheapest_path(surface, at(mesh, {0.01, 0.05, 0}), at(mesh, {0.09, 0.05, 0}),
                             [&](const PathPiece& p) { return surface.length(p); })
                   .has_value());
}

}  // namespace
}  // namespace loosefit::geometry
