// Sinusoidal folds of known direction, on a plane and on a cylinder.
#include "loosefit/maps/wrinkle_direction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/maps/strain.h"
#include "support/flat_garment.h"
#include "support/tube_garment.h"

namespace loosefit::maps {
namespace {

constexpr double kSide = 0.6, kEdge = 0.006;  // [m]

/// Flat square sheet in the (x, z) plane, seen from behind: u = x to the right, v = z upwards.
garment::Garment square_sheet() {
  garment::Garment g;
  const int n = static_cast<int>(std::lround(kSide / kEdge));
  g.panel_names = {"sheet"};
  const auto uv = [&](int i, int j) { return Vec2(kEdge * i, kEdge * j); };
  const auto id = [&](int i, int j) { return j * (n + 1) + i; };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) g.vertex_uv.push_back(uv(i, j));
  testing::add_grid(g, n, n, id, uv);
  g.vertex_count = static_cast<int>(g.vertex_uv.size());
  g.vertex_panel.assign(g.vertex_count, 0);
  return g;
}

/// What the wrinkle code reads of a worn garment: normals, axes, areas, regions.
WornGarment worn_with(const garment::Garment& g, std::vector<Vec3> normals) {
  WornGarment worn;
  worn.normals = std::move(normals);
  worn.segment_axes.assign(g.vertex_count, Vec3::UnitZ());
  worn.regions.assign(g.vertex_count, body::Region::mid_back);
  worn.areas = vertex_areas(g);
  return worn;
}

/// Outward (here −y, to someone who sees x to the right and z up) normals of a sheet with waves of
/// greatest slope `slope` whose lines stand at `angle` to the vertical, counter-clockwise.
std::vector<Vec3> wavy_normals(const garment::Garment& g, double angle, double length,
                               double slope) {
  std::vector<Vec3> normals;
  for (const Vec2& uv : g.vertex_uv) {
    const Vec2 across(std::cos(angle), std::sin(angle));  // square to the lines
    const double tilt = slope * std::sin(2 * kPi / length * across.dot(uv));
    normals.emplace_back(std::sin(tilt) * across.x(), -std::cos(tilt), std::sin(tilt) * across.y());
  }
  return normals;
}

/// Share of a wave of this length that four implicit steps of diffusion take away.
double taken(double length, double width) {
  const double k = 2 * kPi / length;
  return 1 - std::pow(1 + k * k * width * width / 8, -4);
}

/// The tensor of the inner part, where the edges of the sheet are far.
WrinkleDirection inner(const garment::Garment& g, const WornGarment& worn,
                       double width = kWrinkleWidth) {
  const std::vector<Vec2> slopes = wrinkle_slopes(g, worn, width);
  std::vector<Vec2> own;
  std::vector<double> areas;
  for (int v = 0; v < g.vertex_count; ++v)
    if ((g.vertex_uv[v] - Vec2(kSide / 2, kSide / 2)).cwiseAbs().maxCoeff() <= 0.18) {
      own.push_back(slopes[v]);
      areas.push_back(worn.areas[v]);
    }
  return wrinkle_direction(own, areas);
}

TEST(WrinkleDirection, FoldsOfAnyDirectionAreFoundWithTheirSlope) {
  const garment::Garment g = square_sheet();
  const double length = 0.06, slope = radians(20);
  for (double angle : {0.0, 30.0, -50.0, 90.0}) {
    const WrinkleDirection found =
        inner(g, worn_with(g, wavy_normals(g, radians(angle), length, slope)));
    // 90° and −90° are the same direction.
    EXPECT_NEAR(std::cos(2 * found.angle), std::cos(2 * radians(angle)), 0.01) << angle;
    EXPECT_NEAR(std::sin(2 * found.angle), std::sin(2 * radians(angle)), 0.01) << angle;
    EXPECT_GT(found.coherence, 0.995) << angle;
    EXPECT_NEAR(found.slope, slope / std::sqrt(2) * taken(length, kWrinkleWidth),
                0.03 * found.slope)
        << angle;
  }
}

TEST(WrinkleDirection, WideWavesAreTheShapeAndNotWrinkles) {
  const garment::Garment g = square_sheet();
  const double slope = radians(10);
  for (double width : {0.01, 0.03, 0.06}) {
    const double length = 0.12;  // fits three times into the inner part
    const WrinkleDirection found = inner(g, worn_with(g, wavy_normals(g, 0, length, slope)), width);
    const double expected = slope / std::sqrt(2) * taken(length, width);
    EXPECT_NEAR(found.slope, expected, 0.04 * expected) << width;
  }
  EXPECT_LT(taken(0.4, kWrinkleWidth), 0.11);
  EXPECT_GT(taken(0.06, kWrinkleWidth), 0.9);
}

TEST(WrinkleDirection, CrossedFoldsHaveNoDirectionAndUnequalOnesTheirShare) {
  const garment::Garment g = square_sheet();
  const std::vector<double> areas = vertex_areas(g);
  for (double second : {1.0, 0.5}) {
    std::vector<Vec2> slopes;
    for (const Vec2& uv : g.vertex_uv)
      slopes.emplace_back(0.2 * std::sin(2 * kPi * uv.x() / 0.06),
                          0.2 * second * std::sin(2 * kPi * uv.y() / 0.06));
    const WrinkleDirection found = wrinkle_direction(slopes, areas);
    EXPECT_NEAR(found.coherence, (1 - second * second) / (1 + second * second), 1e-3);
    EXPECT_NEAR(found.slope, 0.2 * std::sqrt((1 + second * second) / 2), 1e-3);
    if (second < 1) {
      EXPECT_NEAR(found.angle, 0, 1e-6);
    }
  }
}

TEST(WrinkleDirection, ATubeIsSmoothAndItsFlutesAreVertical) {
  const double radius = 0.12;
  const body::Body body = testing::cylinder_body(0.1, 1.0, 200, 4);
  const garment::Garment g = testing::tube_garment(2 * kPi * radius, 0.4, 240, 60);
  const auto place = [&](double depth) {
    return testing::settled_drape(g, [&](const Vec2& uv) {
      const double a = uv.x() / radius, r = radius + depth * std::cos(12 * a);
      return Vec3(r * std::cos(a), r * std::sin(a), 0.3 + uv.y());
    });
  };
  const auto of = [&](double depth) {
    WornGarment worn = relate(g, place(depth).positions, body);
    worn.segment_axes.assign(g.vertex_count, Vec3::UnitZ());  // the body has no joints
    return wrinkle_direction(wrinkle_slopes(g, worn), worn.areas);
  };
  EXPECT_LT(of(0).slope, radians(0.1)) << "a round tube has no wrinkles, whatever its radius";
  const WrinkleDirection fluted = of(0.003);
  EXPECT_NEAR(degrees(fluted.angle), 0, 0.5);
  EXPECT_GT(fluted.coherence, 0.99);
  EXPECT_GT(fluted.slope, radians(8));
}

TEST(WrinkleDirection, RegionsAreKeptApartAndWhatHasNoAxisIsLeftOut) {
  const garment::Garment g = square_sheet();
  std::vector<Vec3> normals = wavy_normals(g, 0, 0.06, 0.3);
  const std::vector<Vec3> level = wavy_normals(g, kPi / 2, 0.06, 0.3);
  WornGarment worn = worn_with(g, normals);
  for (int v = 0; v < g.vertex_count; ++v) {
    if (g.vertex_uv[v].x() > kSide / 2) {
      worn.regions[v] = body::Region::lower_back;
      worn.normals[v] = level[v];
    }
    if (g.vertex_uv[v].y() < 0.05) {
      worn.regions[v] = body::Region::neck;
      worn.segment_axes[v] = Vec3::Zero();
    }
  }
  const auto found = regional_wrinkles(g, worn);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(degrees(found.at(body::Region::mid_back).angle), 0, 2);
  EXPECT_NEAR(std::abs(degrees(found.at(body::Region::lower_back).angle)), 90, 2);
  EXPECT_TRUE(std::isnan(wrinkle_direction({}, {}).angle));
}

}  // namespace
}  // namespace loosefit::maps
