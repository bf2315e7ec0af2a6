#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/lines/find_routes.h"
#include "support/tube_garment.h"

namespace loosefit::lines {
namespace {

constexpr double kWidth = 0.6, kHeight = 0.4, kFoot = 0.06;
constexpr double kAside = 0.14;  // of the stops from the middle: the seam is the longer way
const Vec2 kMiddle(0.3, 0.2);

/// A sheet with a cone of slope 1 in its middle: stretched by √2 along the slope, nowhere else.
class SheetWithACone : public ::testing::Test {
 protected:
  SheetWithACone() {
    for (const Vec2& uv : garment_.vertex_uv)
      positions_.emplace_back(uv.x(), uv.y(), std::max(0.0, kFoot - (uv - kMiddle).norm()));
    for (const Vec2& uv : garment_.vertex_uv) plane_.emplace_back(uv.x(), uv.y(), 0);
  }
  placement::WornState state(const std::vector<Vec3>& positions) const {
    return {0, 0, positions, body_, worn_};
  }
  placement::GarmentPoint at(double u, double v) const {
    return placement::pattern_point(garment_, "tube", {u, v});
  }
  std::vector<placement::GarmentPoint> across(double v = 0.2) const {
    return {at(0.3 - kAside, v), at(0.3 + kAside, v)};
  }
  LineCourse shortest(const std::vector<placement::GarmentPoint>& stops) const {
    return lay_course(garment_, surface_, stops, placement::LineSpec::Course::shortest, 0.01);
  }
  const garment::Garment garment_ = testing::tube_garment(kWidth, kHeight, 120, 80);
  const geometry::PathSurface surface_ = flat_surface(garment_);
  std::vector<Vec3> positions_, plane_;
  const body::PosedBody body_{testing::cylinder_body(0.02, 0.3, 24, 10)};
  const maps::WornGarment worn_;
};

TEST_F(SheetWithACone, TheRouteIsTheTautStringRoundItsFoot) {
  const Route straight = judged(garment_, shortest(across()), {state(positions_)});
  EXPECT_NEAR(straight.course.length, 2 * kAside, 1e-6);
  EXPECT_NEAR(straight.strain, std::sqrt(2.0) - 1, 0.02);
  EXPECT_NEAR(straight.mean_strain, (std::sqrt(2.0) - 1) * kFoot / kAside, 0.01);

  const std::vector<Route> routes =
      find_routes(garment_, surface_, across(), {state(positions_)}, {.alternatives = 0});
  ASSERT_EQ(routes.size(), 1u);
  const double d = kAside;
  const double taut = 2 * std::sqrt(d * d - kFoot * kFoot) + 2 * kFoot * std::asin(kFoot / d);
  // The rim of the cone is sampled by edges of 5 mm, and a little of it may be cut.
  EXPECT_NEAR(routes[0].course.length, taut, 0.015 * taut);
  EXPECT_LT(routes[0].mean_strain, 0.1 * straight.mean_strain);
  for (const CoursePiece& piece : routes[0].course.pieces) {
    Vec2 place = Vec2::Zero();
    for (int k = 0; k < 3; ++k) place += piece.from[k] * garment_.triangle_uv[piece.triangle][k];
    EXPECT_GT((place - kMiddle).norm(), 0.85 * kFoot);
  }
}

TEST_F(SheetWithACone, WithoutStrainTheRouteIsTheShortestWay) {
  const std::vector<Route> routes = find_routes(garment_, surface_, across(), {state(plane_)});
  EXPECT_NEAR(routes.front().course.length, 2 * kAside, 1e-4);
  EXPECT_NEAR(routes.front().strain, 0, 1e-9);
}

TEST_F(SheetWithACone, TheWorstOfAllStatesCounts) {
  const std::vector<Route> routes = find_routes(
      garment_, surface_, across(), {state(plane_), state(positions_)}, {.alternatives = 0});
  EXPECT_GT(routes.front().course.length, 0.29) << "the second state has the cone";
  EXPECT_NEAR(judged(garment_, shortest(across()), {state(plane_), state(positions_)}).strain,
              std::sqrt(2.0) - 1, 0.02);
}

TEST_F(SheetWithACone, AlternativesLieElsewhere) {
  const std::vector<Route> routes =
      find_routes(garment_, surface_, across(), {state(positions_)}, {.apart = 0.02});
  ASSERT_GE(routes.size(), 2u);
  // The first two pass the cone on either side.
  const auto side = [&](const Route& route) {
    double sum = 0;
    for (const CoursePiece& piece : route.course.pieces)
      for (int k = 0; k < 3; ++k)
        sum +=
            piece.cut * piece.from[k] * (garment_.triangle_uv[piece.triangle][k].y() - kMiddle.y());
    return sum > 0;
  };
  EXPECT_NE(side(routes[0]), side(routes[1]));
  EXPECT_LE(routes[0].mean_strain, routes[1].mean_strain + 1e-6);
}

TEST_F(SheetWithACone, GoesByItsStops) {
  const std::vector<Route> routes =
      find_routes(garment_, surface_, {at(0.16, 0.2), at(0.3, 0.34), at(0.44, 0.2)},
                  {state(positions_)}, {.alternatives = 0});
  EXPECT_NEAR(routes[0].course.length, 2 * std::hypot(0.14, 0.14), 0.003);
  EXPECT_EQ(routes[0].course.stops.size(), 3u);
}

}  // namespace
}  // namespace loosefit::lines
