#include "loosefit/geometry/closest_point_tree.h"

#include <gtest/gtest.h>

#include <random>

#include "support/shapes.h"

namespace loosefit::geometry {
namespace {

TEST(ClosestPointTree, AgreesWithBruteForceInsideOutsideAndOnTheSurface) {
  const TriangleMesh sphere = support::sphere(0.3, 48, 96);  // enough for a tree built in parallel
  const ClosestPointTree tree(sphere);
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> u(-0.5, 0.5);
  for (int i = 0; i < 400; ++i) {
    const Vec3 p = i % 10 == 0 ? sphere.vertices[i] : Vec3(u(rng), u(rng), u(rng));
    EXPECT_DOUBLE_EQ(tree.query(p).distance, closest_point_brute_force(sphere, p).distance);
  }
}

TEST(ClosestPointTree, AgreesWithBruteForceForAnyNumberOfTrianglesAndFarAway) {
  const TriangleMesh sphere = support::sphere(0.3, 24, 48);
  std::mt19937 rng(4);
  std::uniform_real_distribution<double> u(-1, 1);
  for (std::size_t n : {1, 2, 7, 8, 9, 63, 64, 65, 66, 512, 513, 1000}) {
    TriangleMesh part = sphere;
    part.triangles.resize(n);
    const ClosestPointTree tree(part);
    for (double scale : {0.5, 100.0, 1e12, 1e20})
      for (int i = 0; i < 20; ++i) {
        const Vec3 p = scale * Vec3(u(rng), u(rng), u(rng));
        const ClosestPoint found = tree.query(p), expected = closest_point_brute_force(part, p);
        EXPECT_EQ(found.distance, expected.distance) << n << " triangles";
        if (scale < 1) {
          EXPECT_NEAR((found.point - expected.point).norm(), 0, 1e-12) << n << " triangles";
        }
      }
  }
}

TEST(ClosestPointTree, AgreesWithBruteForceCloseToASurfaceFarFromTheOrigin) {
  TriangleMesh sphere = support::sphere(0.3, 24, 48);
  const Vec3 centre(10.1, -20.3, 30.7);  // single precision knows these to a micrometre
  for (Vec3& v : sphere.vertices) v += centre;
  const ClosestPointTree tree(sphere);
  std::mt19937 rng(6);
  std::uniform_real_distribution<double> u(0, 1);
  for (std::size_t i = 0; i < sphere.triangles.size(); i += 3) {
    const Triangle& t = sphere.triangles[i];
    const double a = u(rng), b = (1 - a) * u(rng);
    const Vec3 on_face =
        a * sphere.vertices[t[0]] + b * sphere.vertices[t[1]] + (1 - a - b) * sphere.vertices[t[2]];
    for (const Vec3& base : {on_face, sphere.vertices[t[0]]})
      for (double off : {-1e-4, -1e-6, -1e-9, 0.0, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4}) {
        const Vec3 p = base + off * (base - centre).normalized();
        const ClosestPoint found = tree.query(p), expected = closest_point_brute_force(sphere, p);
        EXPECT_EQ(found.distance, expected.distance);
        EXPECT_EQ(found.triangle, expected.triangle);
      }
  }
}

TEST(ClosestPointTree, ABoxOverlapsTheTrianglesThatBruteForceFinds) {
  const TriangleMesh sphere = support::sphere(0.3, 24, 48);
  std::mt19937 rng(6);
  std::uniform_real_distribution<double> u(-0.4, 0.4), size(0, 0.1);
  for (std::size_t n : {0, 1, 7, 8, 9, 65, 1000}) {
    TriangleMesh part = sphere;
    part.triangles.resize(n);
    const ClosestPointTree tree(part);
    std::vector<Box3> box_of;
    for (const Triangle& t : part.triangles) {
      Box3 box;
      for (int v : t) box.extend(part.vertices[v]);
      box_of.push_back(box);
    }
    std::size_t hits = 0;
    for (int i = 0; i < 200; ++i) {
      const Vec3 p(u(rng), u(rng), u(rng));
      Box3 box(p, p + Vec3(size(rng), size(rng), size(rng)));
      // One that just touches a triangle's.
      if (i % 4 == 0 && n > 0) box = Box3(box_of[i % n].max(), box_of[i % n].max() + Vec3::Ones());
      std::vector<int> expected;
      for (std::size_t t = 0; t < n; ++t)
        if (box_of[t].intersects(box)) expected.push_back(static_cast<int>(t));
      EXPECT_EQ(tree.overlapping(box), expected) << n << " triangles";
      hits += expected.size();
    }
    EXPECT_EQ(hits > 0, n > 0);
  }
}

TEST(ClosestPointTree, TiesGoToTheLowerTriangleAndUnwantedOnesAreLeftOut) {
  const TriangleMesh sphere = support::sphere(0.3, 24, 48);
  const ClosestPointTree tree(sphere);
  const Triangle& t = sphere.triangles[500];
  std::vector<int> round;  // triangles that share the corner
  for (int i = 0; i < static_cast<int>(sphere.triangles.size()); ++i)
    for (int v : sphere.triangles[i])
      if (v == t[0]) round.push_back(i);
  ASSERT_GT(round.size(), 2u);
  const Vec3 p = sphere.vertices[t[0]];
  EXPECT_EQ(tree.query(p).triangle, round.front());
  EXPECT_EQ(tree.query(p, 1, [&](int i) { return i != round.front(); }).triangle, round[1]);
}

TEST(ClosestPointTree, SignedDistanceOfASphereIsRadiusMinusR) {
  const TriangleMesh sphere = support::sphere(0.3, 64, 128);
  const ClosestPointTree tree(sphere);
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> u(-0.5, 0.5);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p(u(rng), u(rng), u(rng));
    EXPECT_NEAR(tree.signed_distance(p), p.norm() - 0.3, 5e-4);
  }
}

TEST(ClosestPointTree, ReportsNothingBeyondTheSearchRadius) {
  const TriangleMesh sphere = support::sphere(0.3, 16, 32);
  EXPECT_EQ(ClosestPointTree(sphere).query(Vec3(1, 0, 0), 0.5).triangle, -1);
  EXPECT_EQ(ClosestPointTree(TriangleMesh{}).query(Vec3(1, 0, 0)).triangle, -1);
}

}  // namespace
}  // namespace loosefit::geometry
