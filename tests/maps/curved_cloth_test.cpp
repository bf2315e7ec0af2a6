// Coarse tubes on a cylinder: what the smooth cloth they stand for is away from it.
#include "loosefit/maps/curved_cloth.h"

#include <gtest/gtest.h>

#include <random>

#include "loosefit/maps/gap.h"
#include "loosefit/maps/worn_garment.h"
#include "support/tube_garment.h"

namespace loosefit::maps {
namespace {

/// A tube whose corners lie at `corners` from the axis [m], of `around` flat strips.
WornGarment tube_on(const body::Body& body, double corners, int around) {
  const double girth = 2 * around * corners * std::sin(kPi / around);
  const garment::Garment tube = testing::tube_garment(girth, 0.06, around, 8);
  std::vector<Vec3> positions;
  for (const Vec2& uv : tube.vertex_uv) {
    const double a = 2 * kPi * uv.x() / girth;
    positions.emplace_back(corners * std::cos(a), corners * std::sin(a), 0.1 + uv.y());
  }
  return relate(tube, positions, body);
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

TEST(CurvedCloth, OfFlatTrianglesThatRestOnTheSkinLiesOnIt) {
  std::mt19937 random(7);
  for (int i = 0; i < 8; ++i) {
    const double radius = std::uniform_real_distribution<double>(0.02, 0.12)(random),
                 half = std::uniform_real_distribution<double>(0.0002, 0.0008)(random);
    const int around = std::uniform_int_distribution<int>(10, 24)(random);
    const body::Body body = testing::cylinder_body(radius, 0.3, 720, 20);
    const double corners = (radius + half) / std::cos(kPi / around), chord = corners - radius - half;
    const WornGarment worn = tube_on(body, corners, around);
    for (const double d : worn.distances)
      EXPECT_NEAR(d, half, 0.08 * chord + 2e-5) << "chord " << chord;
  }
}

TEST(CurvedCloth, OfATubeThatHangsFreeHasTheRadiusOfItsLength) {
  for (const int around : {12, 18, 30}) {
    const double radius = 0.04, smooth = 0.055;
    const body::Body body = testing::cylinder_body(radius, 0.3, 720, 20);
    // As long as the circle.
    const double corners = smooth * (kPi / around) / std::sin(kPi / around);
    const double chord = corners * (1 - std::cos(kPi / around));
    const WornGarment worn = tube_on(body, corners, around);
    for (const double d : worn.distances) EXPECT_NEAR(d, smooth - radius, 0.1 * chord + 2e-5);
    // Between the corners, too.
    for (const CurvedTriangle& t : worn.curved) {
      const double flat = corners * std::cos(kPi / around) - radius;  // along a strip's middle
      EXPECT_NEAR(smooth_distance(t, Vec3(0.5, 0.5, 0), t.bulge[0] > 0.5 * chord ? flat : smooth),
                  smooth - radius, 0.6 * chord);
    }
  }
}

TEST(CurvedCloth, GapAndContactGoOneWayAsATubeGetsLooser) {
  const double radius = 0.026;
  const body::Body body = testing::cylinder_body(radius, 0.3, 720, 20);
  fabric::Material m;
  m.thickness = 0.0006;
  for (const int around : {9, 12, 24}) {
    double last_gap = -1, last_contact = 2;
    for (double off = 0.0003; off < 0.006; off += 0.0002) {
      const WornGarment worn = tube_on(body, (radius + off) / std::cos(kPi / around), around);
      const double gap = mean(worn.distances);
      double touching = 0;
      for (const double d : worn.distances) touching += touches(gap_of(d, m), m);
      const double contact = touching / static_cast<double>(worn.distances.size());
      EXPECT_GE(gap, last_gap - 1e-9) << around << " " << off;
      EXPECT_LE(contact, last_contact) << around << " " << off;
      last_gap = gap, last_contact = contact;
    }
    EXPECT_EQ(last_contact, 0);
  }
}

}  // namespace
}  // namespace loosefit::maps
