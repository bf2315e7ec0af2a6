#include "loosefit/body/section.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/body/tape_paths.h"
#include "support/shapes.h"

namespace loosefit::body {
namespace {

// A torus of tube radius `r` round the z axis at radius `big`.
geometry::TriangleMesh torus(double big, double r, int n, int m) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      const double a = 2 * kPi * i / n, b = 2 * kPi * j / m;
      mesh.vertices.emplace_back((big + r * std::cos(b)) * std::cos(a),
                                 (big + r * std::cos(b)) * std::sin(a), r * std::sin(b));
    }
  }
  const auto at = [&](int i, int j) { return (i % n) * m + j % m; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

TEST(Section, HorizontalCutOfATorusIsTwoCircles) {
  const geometry::TriangleMesh mesh = torus(0.3, 0.1, 400, 200);
  const auto loops = plane_section(mesh, Vec3(0, 0, 0.001), Vec3::UnitZ());
  ASSERT_EQ(loops.size(), 2u);
  const double longest = std::max(loops[0].length, loops[1].length);
  const double shortest = std::min(loops[0].length, loops[1].length);
  EXPECT_NEAR(longest, 2 * kPi * 0.4, 1e-3);
  EXPECT_NEAR(shortest, 2 * kPi * 0.2, 1e-3);
  EXPECT_EQ(trunk_loop(loops)->length, longest);
  EXPECT_EQ(trunk_loop(loops, 5), nullptr);
  EXPECT_NEAR(trunk_girth(mesh, 0.001), 2 * kPi * 0.4, 1e-3);
}

TEST(Section, VerticesOnThePlaneDoNotBreakTheLoops) {
  const geometry::TriangleMesh mesh =
      torus(0.3, 0.1, 40, 20);  // whole rings of vertices lie in z = 0
  const auto loops = plane_section(mesh, Vec3::Zero(), Vec3::UnitZ());
  ASSERT_EQ(loops.size(), 2u);
}

// Half of the torus: its cut is no loop but two half circles, from border to border.
TEST(Section, OpenSurfaceIsCutInChains) {
  geometry::TriangleMesh half = torus(0.3, 0.1, 400, 200);
  std::erase_if(half.triangles, [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](int v) { return half.vertices[v].y() < -1e-9; });
  });
  EXPECT_TRUE(plane_section(half, Vec3(0, 0, 0.001), Vec3::UnitZ()).empty());
  const auto chains = open_chains(half, Vec3(0, 0, 0.001), Vec3::UnitZ());
  ASSERT_EQ(chains.size(), 2u);
  EXPECT_NEAR(chains[0].length + chains[1].length, kPi * (0.4 + 0.2), 1e-3);
  for (const SectionLoop& chain : chains) {
    EXPECT_NEAR(chain.points.front().y(), 0, 1e-6);
    EXPECT_NEAR(chain.points.back().y(), 0, 1e-6);
    EXPECT_NEAR((chain.points.front() - chain.points.back()).norm(), 2 * chain.length / kPi, 1e-3);
  }
  EXPECT_TRUE(open_chains(torus(0.3, 0.1, 40, 20), Vec3(0, 0, 0.001), Vec3::UnitZ()).empty());
}

TEST(Section, VerticalCutFindsTheLoopRoundAPoint) {
  const geometry::TriangleMesh mesh = torus(0.3, 0.1, 400, 200);
  EXPECT_NEAR(girth_round(mesh, Vec3(0.3, 0, 0), Vec3::UnitY()), 2 * kPi * 0.1, 1e-3);
  EXPECT_THROW(girth_round(mesh, Vec3(0, 0, 0), Vec3::UnitY()), GeometryError);
  EXPECT_THROW(trunk_girth(mesh, 0.5), GeometryError);
}

TEST(Section, OpenChainsAreLeftOut) {
  geometry::TriangleMesh mesh = torus(0.3, 0.1, 40, 20);
  mesh.triangles.erase(mesh.triangles.begin(),
                       mesh.triangles.begin() + 40);  // one ring of the tube
  EXPECT_TRUE(plane_section(mesh, Vec3(0, 0, 0.01), Vec3::UnitZ()).empty());
}

TEST(Section, HullBridgesHollows) {
  const std::vector<Vec3> star = {{0, 0, 0}, {2, 0, 0}, {1, 0.2, 0},
                                  {2, 2, 0}, {0, 2, 0}, {0.2, 1, 0}};
  EXPECT_NEAR(hull_perimeter(star, Vec3::UnitZ()), 8, 1e-12);
  EXPECT_EQ(convex_hull({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}, {0.5, 0}}).size(), 4u);
}

TEST(TapePaths, NeckBaseOfACircleIsItsCircumference) {
  const double r = 0.06;
  EXPECT_NEAR(neck_base_girth({r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}), 2 * kPi * r, 1e-6);
  // An ellipse of half axes 3 : 2 has the perimeter 15.8654 (complete elliptic integral).
  EXPECT_NEAR(neck_base_girth({3, 0, 0}, {-3, 0, 0}, {0, 2, 0}, {0, -2, 0}), 15.865439589, 1e-5);
}

TEST(TapePaths, HalfOfARoundTrunkLiesInFront) {
  const geometry::TriangleMesh trunk = loosefit::support::cylinder(0.15, 0, 0.5, 5, 200);
  EXPECT_NEAR(trunk_girth_front(trunk, 0.25), kPi * 0.15, 1e-3);
  geometry::TriangleMesh deep = trunk;  // twice as deep in front
  for (Vec3& p : deep.vertices)
    if (p.y() < 0) p.y() *= 2;
  // Half the perimeter of an ellipse of half axes 1 and 2: 4.8442 (complete elliptic integral).
  EXPECT_NEAR(trunk_girth_front(deep, 0.25), 4.8442 * 0.15, 2e-3);
  EXPECT_NEAR(trunk_girth(deep, 0.25), (4.8442 + kPi) * 0.15, 2e-3);
}

TEST(TapePaths, FrontAndBackTapesFollowTheirOwnSide) {
  geometry::TriangleMesh trunk = loosefit::support::sphere(0.3, 120, 120);
  const Vec3 top(1e-5, 0, 0.3 - 1e-6);
  EXPECT_NEAR(front_tape(trunk, top, 0), 0.15 * kPi, 1e-3);
  EXPECT_NEAR(back_tape(trunk, top, 0), 0.15 * kPi, 1e-3);
  for (Vec3& p : trunk.vertices)
    if (p.y() < 0) p.y() *= 2;
  EXPECT_NEAR(front_tape(trunk, top, 0), 0.5 * 4.8442 * 0.3, 1e-3);
  EXPECT_NEAR(back_tape(trunk, top, 0), 0.15 * kPi, 1e-3);
}

}  // namespace
}  // namespace loosefit::body
