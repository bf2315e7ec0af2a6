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
  const Route straight = judged(garment_, surface_, shortest(across()), {state(positions_)});
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
  EXPECT_NEAR(
      judged(garment_, surface_, shortest(across()), {state(plane_), state(positions_)}).strain,
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

TEST_F(SheetWithACone, ALengthLimitTakesTheStringOverTheCone) {
  const double taut =
      2 * std::sqrt(kAside * kAside - kFoot * kFoot) + 2 * kFoot * std::asin(kFoot / kAside);
  const double limit = 2 * kAside + 0.3 * (taut - 2 * kAside);
  const std::vector<Route> routes = find_routes(garment_, surface_, across(), {state(positions_)},
                                                {.alternatives = 0, .longest = limit});
  EXPECT_LE(routes[0].course.length, limit);
  EXPECT_GT(routes[0].course.length, 2 * kAside + 0.1 * (taut - 2 * kAside))
      << "uses some of what it may";
  const double straight =
      judged(garment_, surface_, shortest(across()), {state(positions_)}).mean_strain;
  EXPECT_LT(routes[0].mean_strain, straight);
  try {
    find_routes(garment_, surface_, across(), {state(positions_)}, {.longest = 0.25});
    ADD_FAILURE();
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place().key, "longest");
    EXPECT_NE(error.expected().find("0.280"), std::string::npos) << error.expected();
  }
}

TEST_F(SheetWithACone, WhatIsKeptFreeIsPassed) {
  // A disc in the flat sheet: the taut string round it.
  std::vector<char> kept(garment_.triangles.size(), 0);
  for (std::size_t t = 0; t < kept.size(); ++t) {
    const auto& uv = garment_.triangle_uv[t];
    kept[t] = ((uv[0] + uv[1] + uv[2]) / 3 - kMiddle).norm() < kFoot;
  }
  const std::vector<Route> routes = find_routes(garment_, surface_, across(), {state(plane_)},
                                                {.alternatives = 0, .kept_free = kept});
  const double taut =
      2 * std::sqrt(kAside * kAside - kFoot * kFoot) + 2 * kFoot * std::asin(kFoot / kAside);
  EXPECT_NEAR(routes[0].course.length, taut, 0.02 * taut);
  for (const CoursePiece& piece : routes[0].course.pieces) EXPECT_FALSE(kept[piece.triangle]);
}

TEST_F(SheetWithACone, ASeamIsCrossedOnlyWhereTheDetourIsDearer) {
  // From side to side of the seam of a round tube, which is the short way.
  const double radius = kWidth / (2 * kPi);
  std::vector<Vec3> tube;
  for (const Vec2& uv : garment_.vertex_uv)
    tube.emplace_back(radius * std::sin(uv.x() / radius), radius * std::cos(uv.x() / radius),
                      uv.y());
  const std::vector<placement::GarmentPoint> stops = {at(0.1, 0.2), at(0.5, 0.2)};
  const auto seams = [&](double seam) {
    const Route route = find_routes(garment_, surface_, stops, {state(tube)},
                                    {.alternatives = 0, .prices = {.seam = seam}})
                            .front();
    return std::pair(route.seams, route.course.length);
  };
  // The way across is 0.2 m, the way round 0.4 m.
  const auto [cheap, across] = seams(0.1);
  EXPECT_EQ(cheap, 1);
  EXPECT_NEAR(across, 0.2, 1e-3);
  const auto [dear, round] = seams(0.3);
  EXPECT_EQ(dear, 0);
  EXPECT_NEAR(round, 0.4, 1e-3);
}

TEST_F(SheetWithACone, BendingIsPaidForAtItsRadius) {
  // A cylinder of radius R: nothing is stretched, a way round it bends with 1/R.
  const double radius = 0.05;
  std::vector<Vec3> bent;
  for (const Vec2& uv : garment_.vertex_uv) {
    const double angle = (uv.x() - kMiddle.x()) / radius;
    bent.emplace_back(radius * std::sin(angle), radius * std::cos(angle), uv.y());
  }
  const Route round = judged(garment_, surface_, shortest(across()), {state(bent)});
  EXPECT_NEAR(round.bend_radius, radius, 0.02 * radius);
  EXPECT_LT(round.strain, 0.002);
  const std::vector<placement::WornState> states = {state(bent)};
  const RouteCost priced(garment_, states, {.own_strain = 0.01, .bending = 0.001});
  double sum = 0;
  for (const CoursePiece& piece : round.course.pieces) sum += priced.of(piece);
  EXPECT_NEAR(sum, 2 * kAside * (0.01 + 0.001 / radius), 0.02 * sum);
}

}  // namespace
}  // namespace loosefit::lines
