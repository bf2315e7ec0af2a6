#include "loosefit/maps/air_gap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "support/tube_garment.h"

namespace loosefit::maps {
namespace {

constexpr double kRadius = 0.12, kHeight = 0.4;

/// A tube of radius R round a cylinder, its axis `off` to the side.
struct Tube {
  body::Body body = testing::cylinder_body(kRadius, 1.0, 400, 40);
  garment::Garment garment;
  std::vector<Vec3> positions;

  explicit Tube(double radius, double off = 0, double wave = 0)
      : garment(testing::tube_garment(2 * kPi * radius, kHeight, 400, 20)) {
    positions = testing::settled_drape(garment, [=](const Vec2& uv) {
                  const double a = uv.x() / radius, r = radius * (1 + wave * std::cos(9 * a));
                  return Vec3(off + r * std::cos(a), r * std::sin(a), 0.3 + uv.y());
                }).positions;
  }
  WornGarment worn() const { return relate(garment, positions, body); }
};

TEST(AirGap, RingHasTheVolumeBetweenTwoCylinders) {
  for (double half_thickness : {0.0, 0.5e-3}) {
    const double radius = 0.15;
    const Tube tube(radius);
    const AirGap air = air_gap(tube.garment, tube.positions, tube.worn(), half_thickness);
    const double inner = radius - half_thickness;
    EXPECT_NEAR(air.volume, kPi * (inner * inner - kRadius * kRadius) * kHeight, 2e-6);
    EXPECT_NEAR(air.skin_area, 2 * kPi * kRadius * kHeight, 1e-4);
    EXPECT_NEAR(air.mean_gap(), (inner * inner - kRadius * kRadius) / (2 * kRadius), 2e-5)
        << "volume over skin, which is more than the width of the ring";
  }
}

TEST(AirGap, HangingToOneSideAndFoldsChangeNoVolumeButThatOfTheCloth) {
  const double radius = 0.15;
  const Tube middle(radius), side(radius, 0.02), folded(radius, 0, 0.05);
  const double ring = air_gap(middle.garment, middle.positions, middle.worn(), 0).volume;
  EXPECT_NEAR(air_gap(side.garment, side.positions, side.worn(), 0).volume, ring, 0.002 * ring);
  // The mean of R² (1 + w cos)² is R² (1 + w²/2).
  const double more = kPi * radius * radius * 0.5 * 0.05 * 0.05 * kHeight;
  EXPECT_NEAR(air_gap(folded.garment, folded.positions, folded.worn(), 0).volume, ring + more,
              0.004 * ring);
}

TEST(AirGap, PartsAddUpToTheWhole) {
  const Tube tube(0.15, 0.01);
  const WornGarment worn = tube.worn();
  const auto left = [&](int t) { return tube.positions[tube.garment.triangles[t][0]].x() > 0; };
  const AirGap all = air_gap(tube.garment, tube.positions, worn, 0),
               one = air_gap(tube.garment, tube.positions, worn, 0, left),
               other =
                   air_gap(tube.garment, tube.positions, worn, 0, [&](int t) { return !left(t); });
  EXPECT_NEAR(one.volume + other.volume, all.volume, 1e-12);
  EXPECT_GT(one.volume, other.volume) << "it hangs to that side";
}

// Partners of a tube lie level with it.
TEST(AirBetween, IsTheSliceBetweenTwoHeights) {
  const Tube tube(0.15);
  const WornGarment worn = tube.worn();
  const double ring = kPi * (0.15 * 0.15 - kRadius * kRadius);
  const auto between = [&](double low, double high, const std::function<bool(int)>& counts = {}) {
    return air_between(tube.garment, tube.positions, worn, 0, low, high, counts);
  };
  EXPECT_NEAR(between(0.413, 0.5), ring * 0.087, 1e-4 * ring);
  EXPECT_NEAR(between(0.2, 0.8), ring * kHeight, 1e-4 * ring) << "no more than there is";
  EXPECT_NEAR(between(0.2, 0.8), air_gap(tube.garment, tube.positions, worn, 0).volume, 1e-9);
  EXPECT_NEAR(between(0.3, 0.41) + between(0.41, 0.7), between(0.3, 0.7), 1e-12);
  const auto left = [&](int t) { return tube.positions[tube.garment.triangles[t][0]].x() > 0; };
  EXPECT_NEAR(between(0.413, 0.5, left) + between(0.413, 0.5, [&](int t) { return !left(t); }),
              between(0.413, 0.5), 1e-12);
}

// Round a ball partners lie lower than their cloth below its middle: the prisms slant, and what the
// cloth of a height covers is not what lies between the heights.
TEST(AirBetween, OfSlantedPrismsIsThatOfTheHeights) {
  const double r = 0.12, big = 0.15, low = -0.06, high = -0.02;
  // Prisms of a spherical shell, 60° to 120° from the axis: exact between two heights.
  body::Body ball = testing::cylinder_body(r, 1.0, 400, 200);
  for (std::size_t v = 0; v + 2 < ball.surface.vertices.size(); ++v) {
    Vec3& x = ball.surface.vertices[v];
    const double polar = 0.02 + (kPi - 0.04) * (1 - x.z()), azimuth = std::atan2(x.y(), x.x());
    x = r * Vec3(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                 std::cos(polar));
    ball.normals[v] = x.normalized();
  }
  const std::size_t poles = ball.surface.vertices.size() - 2;
  ball.surface.vertices[poles] = Vec3(0, 0, -r), ball.surface.vertices[poles + 1] = Vec3(0, 0, r);
  const garment::Garment g = testing::tube_garment(2 * kPi, 1, 400, 100);
  const auto positions =
      testing::settled_drape(g, [&](const Vec2& uv) {
        const double polar = radians(150 - 120 * uv.y());
        return Vec3(big * std::sin(polar) * std::cos(uv.x()),
                    big * std::sin(polar) * std::sin(uv.x()), big * std::cos(polar));
      }).positions;
  const WornGarment worn = relate(g, positions, ball);
  const double shell = kPi * (big * big - r * r) * (high - low);  // z² cancels
  EXPECT_NEAR(air_between(g, positions, worn, 0, low, high), shell, 2e-3 * shell);
  const double covered =
      air_gap(g, positions, worn, 0, [&](int t) {
        const Triangle& c = g.triangles[t];
        const double z = (positions[c[0]].z() + positions[c[1]].z() + positions[c[2]].z()) / 3;
        return z > low && z < high;
      }).volume;
  EXPECT_LT(covered, 0.95 * shell);
}

TEST(ContactShare, OfATubeThatTouchesAlongALineIsThatOfTwoCircles) {
  const double radius = 0.14, off = radius - kRadius, half_thickness = 0.25e-3;
  const Tube tube(radius + half_thickness, off);
  const auto gaps = skin_gaps(tube.body, tube.garment, tube.positions, half_thickness);
  int covered = 0;
  for (double gap : gaps) covered += !std::isnan(gap);
  EXPECT_GT(covered, 400 * 14);
  EXPECT_LT(covered, 400 * 17) << "0.4 of the metre, less the rims";
  for (double g0 : {1e-3, 3e-3, 0.01}) {
    // Gap of skin at the angle φ from the touching line: R − |r e(φ) − c|, c on the other side.
    double low = 0, high = kPi;
    for (int k = 0; k < 60; ++k) {
      const double phi = 0.5 * (low + high);
      const double gap =
          radius - (kRadius * Vec2(std::cos(phi), std::sin(phi)) + Vec2(off, 0)).norm();
      (gap < g0 ? low : high) = phi;
    }
    // The tube lies at +off, so it touches at −x; |r e + c| there with φ from −x.
    EXPECT_NEAR(contact_share(tube.body, gaps, g0), low / kPi, 0.01) << g0;
  }
  EXPECT_TRUE(std::isnan(contact_share(tube.body, gaps, 1e-3, [](int) { return false; })));
}

}  // namespace
}  // namespace loosefit::maps
