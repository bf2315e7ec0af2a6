#include "loosefit/maps/gap.h"

#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/maps/compute_maps.h"
#include "loosefit/maps/pressure.h"
#include "support/tube_garment.h"
#include "support/wall_and_patch.h"

namespace loosefit::maps {
namespace {

fabric::Material cloth(double thickness) {
  fabric::Material m;
  m.thickness = thickness;
  return m;
}

TEST(Gap, BeginsAtTheInnerFace) {
  EXPECT_DOUBLE_EQ(gap_of(0.010, cloth(0.001)), 0.0095);
  EXPECT_DOUBLE_EQ(gap_of(0.0005, cloth(0.001)), 0);
  EXPECT_DOUBLE_EQ(gap_of(0.0001, cloth(0.001)), 0);
}

TEST(Gap, IsContactUpToTheToleranceOfTheFabric) {
  // docs/theory/sensor_metrics.md 4: half a millimetre, for thick cloth 1.5 times the contact
  // offset.
  EXPECT_TRUE(touches(0.00049, cloth(0.0004)));
  EXPECT_FALSE(touches(0.00051, cloth(0.0004)));
  EXPECT_TRUE(touches(0.00149, cloth(0.002)));
  EXPECT_FALSE(touches(0.00151, cloth(0.002)));
}

TEST(Gap, OfAConcentricTubeIsTheDifferenceOfRadiiLessHalfTheThickness) {
  const body::Body body = testing::cylinder_body(0.1, 1.0, 400, 20);
  const fabric::Material m = cloth(0.002);
  const garment::Garment tube = testing::tube_garment(2 * kPi * 0.11, 0.2, 100, 8);
  const drape::Drape d = testing::settled_drape(tube, [&](const Vec2& uv) {
    const double a = uv.x() / 0.11;
    return Vec3(0.11 * std::cos(a), 0.11 * std::sin(a), 0.4 + uv.y());
  });
  const auto maps = compute_maps(tube, d, body, {"gap"}, {.material = &m});
  ASSERT_EQ(maps.size(), 3u);
  EXPECT_EQ(maps[0].array, "gap_mm");
  EXPECT_EQ(maps[1].array, "contact");
  // Corners stand out of the smooth cloth by a third of the chord's height.
  const double lift = 110 * (1 - std::cos(kPi / 100)) / 3;
  for (double gap : maps[0].values) EXPECT_NEAR(gap, 9 - lift, 0.004);
  for (double contact : maps[1].values) EXPECT_EQ(contact, 0);
}

TEST(Gap, OfATiltedPlaneGrowsWithTheSineAndTouchesWhereItIsBelowTheTolerance) {
  const garment::Garment patch = testing::patch_garment(0.1, 0.0025);
  const fabric::Material m = cloth(0.001);
  const double tilt = radians(5);
  // Turned about the edge u = −0.05, which lies on the skin.
  const auto positions = testing::before_wall(patch, 0.0005 + 0.05 * std::sin(tilt),
                                              testing::turn_about(Vec3::UnitZ(), -tilt));
  const WornGarment worn = relate(patch, positions, testing::wall_body());
  const auto maps = make_maps("gap", {patch, positions, worn, &m});
  for (int v = 0; v < patch.vertex_count; ++v) {
    const double gap = (patch.vertex_uv[v].x() + 0.05) * std::sin(tilt);
    EXPECT_NEAR(maps[0].values[v], 1000 * gap, 1e-6);
    EXPECT_EQ(maps[1].values[v], gap < 0.00075 ? 1 : 0);
  }
}

// One is a matter of distance, the other of force.
TEST(Gap, ContactIsNearAndPressedIsBorne) {
  const garment::Garment patch = testing::patch_garment(0.1, 0.02);
  const fabric::Material m = cloth(0.001);
  for (const double away : {0.0006, 0.002}) {
    const auto positions = testing::before_wall(patch, away, Mat3::Identity());
    const WornGarment worn = relate(patch, positions, testing::wall_body());
    PressureField pressure;
    pressure.contact.assign(patch.vertex_count, 20.0);  // less than counts
    pressure.contact[3] = 100;
    const auto maps = make_maps("gap", {patch, positions, worn, &m, &pressure});
    for (int v = 0; v < patch.vertex_count; ++v) {
      EXPECT_EQ(maps[1].values[v], away < 0.001 ? 1 : 0);
      EXPECT_EQ(maps[2].values[v], v == 3 ? 1 : 0);
    }
    const auto without = make_maps("gap", {patch, positions, worn, &m});
    for (const double pressed : without[2].values) EXPECT_TRUE(std::isnan(pressed));
  }
}

TEST(Gap, ShowsWhereClothBridgesAHollow) {
  // A groove 30 mm wide and 10 mm deep along z under a flat patch that lies on both banks.
  const body::Body body = testing::wall_body(
      {{0.5, 0}, {0.015, 0}, {0.01499, -0.01}, {-0.01499, -0.01}, {-0.015, 0}, {-0.5, 0}});
  const garment::Garment patch = testing::patch_garment(0.1, 0.0025);
  const fabric::Material m = cloth(0.001);
  const auto positions = testing::before_wall(patch, 0.0005);
  const WornGarment worn = relate(patch, positions, body);
  const auto maps = make_maps("gap", {patch, positions, worn, &m});
  // Off a bank the edge is the nearest skin until the floor is: √(x² + ½t²) − ½t.
  const double reach = std::sqrt(std::pow(0.00075 + 0.0005, 2) - std::pow(0.0005, 2));
  for (int v = 0; v < patch.vertex_count; ++v) {
    const double inside = 0.015 - std::abs(patch.vertex_uv[v].x());
    const double gap = inside <= 0 ? 0 : std::min(std::hypot(inside, 0.0005), 0.0105) - 0.0005;
    EXPECT_NEAR(maps[0].values[v], 1000 * gap, 0.02);
    EXPECT_EQ(maps[1].values[v], inside < reach ? 1 : 0);
  }
}

TEST(Gap, NeedsTheMaterial) {
  const garment::Garment tube = testing::tube_garment(0.8, 0.2, 24, 4);
  const drape::Drape d = testing::settled_drape(tube, [](const Vec2& uv) {
    const double a = 2 * kPi * uv.x() / 0.8;
    return Vec3(0.13 * std::cos(a), 0.13 * std::sin(a), 0.4 + uv.y());
  });
  EXPECT_THROW(compute_maps(tube, d, testing::cylinder_body(0.12, 1, 24, 4), {"gap"}),
               InvalidInput);
}

}  // namespace
}  // namespace loosefit::maps
