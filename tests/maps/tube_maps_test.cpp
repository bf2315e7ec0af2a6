// Tubes on a cylinder: the closed forms of worn garments without wrinkles.
#include <gtest/gtest.h>

#include "loosefit/base/error.h"
#include "loosefit/maps/compute_maps.h"
#include "loosefit/maps/girth.h"
#include "loosefit/maps/statistics.h"
#include "loosefit/maps/strain.h"
#include "support/tube_garment.h"

namespace loosefit::maps {
namespace {

constexpr double kRadius = 0.12;  // [m]

const PerformanceMap& find(const std::vector<PerformanceMap>& maps, const std::string& array) {
  for (const PerformanceMap& map : maps)
    if (map.array == array) return map;
  throw std::runtime_error(array);
}

TEST(TubeMaps, ConcentricTubeHasItsGapAndNoDeviation) {
  const body::Body body = testing::cylinder_body(kRadius, 1.0, 400, 40);
  for (double bgm : {0.05, 0.2, 0.45}) {
    const double radius = kRadius * (1 + bgm);
    const garment::Garment g = testing::tube_garment(2 * kPi * radius, 0.4, 400, 20);
    const drape::Drape d = testing::settled_drape(g, [&](const Vec2& uv) {
      const double a = uv.x() / radius;
      return Vec3(radius * std::cos(a), radius * std::sin(a), 0.3 + uv.y());
    });
    const fabric::Material material;
    const auto maps = compute_maps(g, d, body, default_map_names(), {.material = &material});
    const double facet = 1000 * kRadius * (1 - std::cos(kPi / 400));  // chord of the body mesh [mm]
    for (double gap : find(maps, "distance_mm").values)
      EXPECT_NEAR(gap, 1000 * kRadius * bgm, facet + 1e-6);
    for (double angle : find(maps, "angular_deviation_deg").values) EXPECT_NEAR(angle, 0, 0.46);
    const MapStatistics deviation =
        statistics(find(maps, "angular_deviation_deg").values, vertex_areas(g));
    EXPECT_LT(deviation.median, 0.01);
    for (double strain : find(maps, "strain_warp").values) EXPECT_NEAR(strain, 0, 1e-12);
    for (double strain : find(maps, "strain_weft").values) EXPECT_NEAR(strain, 0, 2e-5);
  }
}

/// docs/theory/validation.md 8: a tube that touches the cylinder along one line.
struct Loose {
  double bgm, max_angle, mean_angle, mean_gap, max_gap;
};
class EccentricTube : public ::testing::TestWithParam<Loose> {};

TEST_P(EccentricTube, MeetsTheClosedForm) {
  const Loose expected = GetParam();
  const body::Body body = testing::cylinder_body(kRadius, 1.0, 720, 4);
  const double radius = kRadius * (1 + expected.bgm), offset = radius - kRadius;
  const garment::Garment g = testing::tube_garment(2 * kPi * radius, 0.2, 720, 8);
  const drape::Drape d = testing::settled_drape(g, [&](const Vec2& uv) {
    const double a = uv.x() / radius;
    return Vec3(offset + radius * std::cos(a), radius * std::sin(a), 0.4 + uv.y());
  });
  const auto maps = compute_maps(g, d, body, {"distance", "angular-deviation"});
  const auto areas = vertex_areas(g);
  const MapStatistics gap = statistics(find(maps, "distance_mm").values, areas);
  const MapStatistics angle = statistics(find(maps, "angular_deviation_deg").values, areas);
  EXPECT_NEAR(gap.area_mean, expected.mean_gap, 0.01);
  EXPECT_NEAR(gap.max, expected.max_gap, 0.01);
  EXPECT_NEAR(gap.min, 0, 0.002);
  // Normals of the rim lean by half an element, hence the median-like tolerance in degrees.
  EXPECT_NEAR(angle.max, expected.max_angle, 0.26);
  EXPECT_NEAR(angle.area_mean, expected.mean_angle, 0.02);
}
INSTANTIATE_TEST_SUITE_P(Table, EccentricTube,
                         ::testing::Values(Loose{0.05, 2.72940, 1.73737, 6.07144, 12},
                                           Loose{0.1, 5.21591, 3.31902, 12.27287, 24},
                                           Loose{0.2, 9.59407, 6.09822, 25.00175, 48},
                                           Loose{0.3, 13.34236, 8.46824, 38.08393, 72},
                                           Loose{0.5, 19.47122, 12.31502, 65.03573, 120}));

TEST(TubeMaps, ParticleDistanceIsNeverBelowTheExactOne) {
  const body::Body body = testing::cylinder_body(kRadius, 1.0, 40, 20);  // coarse: 19 × 50 mm
  const garment::Garment g = testing::tube_garment(2 * kPi * 0.13, 0.4, 173, 31);
  const drape::Drape d = testing::settled_drape(g, [&](const Vec2& uv) {
    const double a = uv.x() / 0.13;
    return Vec3(0.13 * std::cos(a), 0.13 * std::sin(a), 0.3 + uv.y());
  });
  const auto maps = compute_maps(g, d, body, {"distance"});
  const auto &exact = find(maps, "distance_mm").values,
             &particle = find(maps, "distance_particle_mm").values;
  double excess = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_GE(particle[i], exact[i] - 1e-9);
    excess = std::max(excess, particle[i] - exact[i]);
  }
  EXPECT_GT(excess, 5);  // the bias of the particle form on a coarse body is what makes it second
}

TEST(TubeMaps, TightTubeHasTheHoopStrainOfItsFit) {
  for (double bgm : {-0.05, -0.15}) {
    const double flat = 2 * kPi * kRadius * (1 + bgm);
    const body::Body body = testing::cylinder_body(kRadius, 1.0, 200, 20);
    const garment::Garment g = testing::tube_garment(flat, 0.4, 2000, 10);
    const drape::Drape d = testing::settled_drape(g, [&](const Vec2& uv) {
      const double a = 2 * kPi * uv.x() / flat;
      return Vec3(kRadius * std::cos(a), kRadius * std::sin(a), 0.3 + uv.y());
    });
    const WornGarment worn = relate(g, d.positions, body);
    const GarmentGirth girth = torso_girth(g, d.positions, worn, 0.5);
    EXPECT_NEAR(girth.flat, flat, 1e-9);
    EXPECT_NEAR(girth.draped, 2 * kPi * kRadius, 1e-5);
    EXPECT_NEAR(girth.hoop_strain(), -bgm / (1 + bgm), 1e-5);
    EXPECT_TRUE(std::isnan(torso_girth(g, d.positions, worn, 0.9).hoop_strain()));
    const fabric::Material material;
    const auto maps = compute_maps(g, d, worn, {"strain"}, {.material = &material});
    for (double strain : find(maps, "strain_weft").values)
      EXPECT_NEAR(strain, -bgm / (1 + bgm), 1e-5);
  }
}

class SealedDrape : public ::testing::Test {
 protected:
  fabric::Material material_;
  MapOptions options_ = {.material = &material_};
  body::Body body_ = testing::cylinder_body(kRadius, 1.0, 24, 4);
  garment::Garment garment_ = testing::tube_garment(0.8, 0.2, 24, 4);
  drape::Drape drape_ = testing::settled_drape(garment_, [](const Vec2& uv) {
    const double a = 2 * kPi * uv.x() / 0.8;
    return Vec3(0.13 * std::cos(a), 0.13 * std::sin(a), 0.4 + uv.y());
  });
};

TEST_F(SealedDrape, IsRefusedUnlessAskedByName) {
  EXPECT_NO_THROW(compute_maps(garment_, drape_, body_, default_map_names(), options_));
  for (int fault = 0; fault < 3; ++fault) {
    drape::Drape bad = drape_;
    if (fault == 0) bad.certificate.residual = 2e-3;
    if (fault == 1) bad.certificate.intersections_body = 1;
    if (fault == 2) bad.certificate.intersections_self = -1;
    EXPECT_THROW(compute_maps(garment_, bad, body_, default_map_names(), options_), Error) << fault;
    MapOptions by_name = options_;
    by_name.allow_unsettled = true;
    EXPECT_EQ(compute_maps(garment_, bad, body_, default_map_names(), by_name).size(), 14u);
  }
}

TEST_F(SealedDrape, UnknownMapsAreNamedWithAHint) {
  try {
    compute_maps(garment_, drape_, body_, {"distanse"});
    FAIL();
  } catch (const InvalidInput& e) {
    EXPECT_NE(std::string(e.what()).find("distanse"), std::string::npos);
    EXPECT_NE(e.hint().find("distance"), std::string::npos);
  }
}

TEST_F(SealedDrape, PositionsMustFitTheGarment) {
  drape_.positions.pop_back();
  EXPECT_THROW(compute_maps(garment_, drape_, body_, default_map_names(), options_), InvalidInput);
}

TEST(Angle, IsExactNearZeroAndBeyondARightAngle) {
  EXPECT_NEAR(angle_between({1, 0, 0}, Vec3(std::cos(1e-9), std::sin(1e-9), 0)), 1e-9, 1e-17);
  EXPECT_NEAR(angle_between({1, 0, 0}, {-1, 0, 0}), kPi, 1e-14);
  EXPECT_NEAR(angle_between({0, 0, 1}, Vec3(1, 0, -1).normalized()), radians(135.0), 1e-14);
}

}  // namespace
}  // namespace loosefit::maps
