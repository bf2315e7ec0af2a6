#include "loosefit/body/scan_parts.h"

#include <gtest/gtest.h>

#include <random>

#include "loosefit/body/body_check.h"
#include "loosefit/body/surface_topology.h"
#include "support/cut_scan.h"
#include "support/shapes.h"

namespace loosefit::body {
namespace {

geometry::TriangleMesh ball(double radius, const Vec3& middle) {
  geometry::TriangleMesh mesh = support::sphere(radius, 24, 32);
  for (Vec3& p : mesh.vertices) p += middle;
  return mesh;
}

double area(const geometry::TriangleMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles)
    sum +=
        geometry::triangle_area(mesh.vertices[std::size_t(t[0])], mesh.vertices[std::size_t(t[1])],
                                mesh.vertices[std::size_t(t[2])]);
  return sum;
}

TEST(ScanParts, LookOutwardsClosedOrOpen) {
  std::mt19937 draw(3);
  for (int i = 0; i < 6; ++i) {
    geometry::TriangleMesh one = ball(0.2, Vec3(0, 0, 1)), other = ball(0.1, Vec3(0.5, 0, 1));
    const double cut = std::uniform_real_distribution<double>(0.9, 1.1)(draw);
    std::erase_if(one.triangles, [&](const Triangle& t) {  // a bowl
      return one.vertices[std::size_t(t[0])].z() > cut;
    });
    const bool turned[2] = {i % 2 == 1, i % 3 == 1};
    for (auto& t : one.triangles)
      if (turned[0]) std::swap(t[1], t[2]);
    for (auto& t : other.triangles)
      if (turned[1]) std::swap(t[1], t[2]);
    geometry::TriangleMesh mesh = support::together({one, other});
    EXPECT_EQ(turn_parts_outwards(mesh), int(turned[0]) + int(turned[1]));
    for (const Triangle& t : mesh.triangles) {
      const Vec3& a = mesh.vertices[std::size_t(t[0])];
      const Vec3 middle(a.x() > 0.3 ? 0.5 : 0.0, 0, 1);
      const Vec3 n = geometry::triangle_normal(a, mesh.vertices[std::size_t(t[1])],
                                               mesh.vertices[std::size_t(t[2])]);
      EXPECT_GT(n.dot(a - middle), 0);
    }
  }
}

// Two balls that overlap: what lies in the other one is a cap of each, by Archimedes 2πrh.
TEST(ScanParts, WhatLiesInsideOfAnotherPartIsNoSkin) {
  for (const double apart : {0.24, 0.30, 0.36}) {
    const double radius = 0.2, height = radius - apart / 2;
    const geometry::TriangleMesh mesh =
        support::together({ball(radius, Vec3(0, 0, 1)), ball(radius, Vec3(apart, 0, 1))});
    const SkinOfParts skin = skin_of_parts(mesh);
    EXPECT_NEAR(skin.inside, height / (2 * radius), 0.04) << apart;
    EXPECT_LT(area(skin.mesh), (1 - skin.inside + 0.01) * area(mesh));
  }
}

// The cut faces of parts that were cut apart look at each other over a gap.
TEST(ScanParts, FacesOfACutAreNoSkin) {
  for (const double gap : {0.001, 0.008, 0.02}) {
    geometry::TriangleMesh low = ball(0.2, Vec3(0, 0, 1)), high = low;
    for (Vec3& p : low.vertices) p.z() = std::min(p.z(), 1.0 - gap / 2);
    for (Vec3& p : high.vertices) p.z() = std::max(p.z(), 1.0 + gap / 2);
    const auto drop_flat = [](geometry::TriangleMesh& mesh) {
      std::erase_if(mesh.triangles, [&](const Triangle& t) {
        return std::abs(mesh.vertices[std::size_t(t[0])].z() -
                        mesh.vertices[std::size_t(t[1])].z()) < 1e-9 &&
               std::abs(mesh.vertices[std::size_t(t[0])].z() -
                        mesh.vertices[std::size_t(t[2])].z()) < 1e-9;
      });
      drop_unused_vertices(mesh);
      support::close(mesh);
    };
    drop_flat(low), drop_flat(high);
    const geometry::TriangleMesh mesh = support::together({low, high});
    ASSERT_EQ(connected_pieces(mesh).size(), 2u);
    const SkinOfParts skin = skin_of_parts(mesh);
    EXPECT_NEAR(area(skin.mesh), 4 * kPi * 0.2 * 0.2, 0.1 * area(mesh)) << gap;
    EXPECT_LT(skin.inside, 0.01);
  }
}

TEST(ScanParts, WhatIsNotOnThePersonIsForeign) {
  const geometry::TriangleMesh person = ball(0.3, Vec3(0, 0, 1));
  const geometry::TriangleMesh scan = support::together(
      {ball(0.3, Vec3(0, 0, 1)), ball(0.05, Vec3(0.28, 0, 1)), ball(0.1, Vec3(-1, 0, 0.4))});
  const auto foreign = foreign_parts(scan, person);
  ASSERT_EQ(foreign.size(), 1u);
  EXPECT_NEAR(foreign[0].share, 0.01 / (0.01 + 0.09 + 0.0025), 0.01);
  EXPECT_NE(foreign[0].place.find("0.40 m above the floor, 1.00 m to the right"), std::string::npos)
      << foreign[0].place;
}

}  // namespace
}  // namespace loosefit::body
