#include "loosefit/placement/shift_along_cloth.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "loosefit/garment/assemble.h"
#include "loosefit/placement/footprint.h"
#include "loosefit/placement/footprint_unfold.h"
#include "support/shirt_kind.h"
#include "support/shirt_on_body.h"
#include "support/simple_patterns.h"

namespace loosefit::placement {
namespace {

using testing_support::polygon_panel;
using testing_support::rectangle_panel;
using testing_support::stitch;

garment::Garment sewn(std::vector<pattern::Panel> panels, std::vector<pattern::Stitch> stitches,
                      double edge_length = 0.01) {
  pattern::Pattern pattern;
  pattern.panels = std::move(panels);
  pattern.stitches = std::move(stitches);
  return garment::assemble(pattern, edge_length, {});
}

std::string panel_of(const garment::Garment& garment, const GarmentPoint& point) {
  return garment.panel_names[garment.triangle_panel[point.triangle]];
}

/// Two squares of 0.1 m, edge `first` of a sewn to edge `second` of b.
struct Squares {
  garment::Garment garment;
  Squares(int first, int second, bool right_wrong)
      : garment(sewn({rectangle_panel("a", 0.1, 0.1), rectangle_panel("b", 0.1, 0.1)},
                     {stitch(0, first, 1, second, right_wrong)})) {}
  /// Shifts a place of a and expects where in b it comes to lie, and the axis with it.
  void expect(const Vec2& from, const Vec2& shift, const Vec2& in_b, const Mat2& turn) const {
    const auto end = shifted(garment, pattern_point(garment, "a", from), shift);
    ASSERT_TRUE(end) << from.transpose() << " by " << shift.transpose();
    EXPECT_EQ(panel_of(garment, end->point), "b");
    EXPECT_LT((pattern_place(garment, end->point) - in_b).norm(), 1e-9) << from.transpose();
    for (const double angle : {0.0, radians(30.0), radians(-110.0)})
      EXPECT_LT((axis_in_pattern(end->angle(angle)) - turn * axis_in_pattern(angle)).norm(), 1e-9);
  }
};

const Mat2 kTurned = Eigen::Rotation2Dd(kPi / 2).toRotationMatrix();

TEST(ShiftAlongCloth, StaysAsDrawnWithinAPanel) {
  const Squares squares(1, 3, false);
  const auto end =
      shifted(squares.garment, pattern_point(squares.garment, "a", {0.02, 0.03}), {0.05, 0.04});
  ASSERT_TRUE(end);
  EXPECT_EQ(panel_of(squares.garment, end->point), "a");
  EXPECT_LT((pattern_place(squares.garment, end->point) - Vec2(0.07, 0.07)).norm(), 1e-9);
  EXPECT_EQ(end->angle(4.0), 4.0) << "not brought into a range";
}

// The right edge of a on the lower one of b: what leads right in a leads up in b.
TEST(ShiftAlongCloth, TurnsWithThePieceBeyondASeam) {
  const Squares squares(1, 0, false);
  const auto end =
      shifted(squares.garment, pattern_point(squares.garment, "a", {0.09, 0.04}), {0.03, 0.01});
  ASSERT_TRUE(end);
  EXPECT_NEAR(end->angle(radians(350.0)), radians(80.0), 1e-9) << "a scenario takes up to 360";
  squares.expect({0.09, 0.04}, {0.03, 0.01}, {0.05, 0.02}, kTurned);
  squares.expect({0.05, 0.0731}, {0.1, -0.05}, {0.0769, 0.05}, kTurned);
}

// Both right edges start to start: b lies turned over, and what leads right leads left there.
TEST(ShiftAlongCloth, IsMirroredBehindARightToWrongSeam) {
  Mat2 mirror;
  mirror << -1, 0, 0, 1;
  Squares(1, 1, true).expect({0.09, 0.04}, {0.03, 0.01}, {0.08, 0.05}, mirror);
  mirror << 0, 1, 1, 0;
  Squares(1, 0, true).expect({0.09, 0.04}, {0.03, 0.01}, {0.05, 0.02}, mirror);
}

// Places of the grid are corners of triangles, the lines along its edges and diagonals.
TEST(ShiftAlongCloth, GoesThroughCornersAndAlongEdges) {
  const Squares squares(1, 3, false);
  for (const garment::Garment::EdgeChain& chain : squares.garment.edge_chains) {
    if (chain.panel != 0 || chain.edge != 3) continue;
    for (const int vertex : chain.vertices) {
      const Vec2 from = squares.garment.vertex_uv[vertex];
      squares.expect(from, {0.14, 0}, from + Vec2(0.04, 0), Mat2::Identity());
      squares.expect(from, {0.15, 0.05 - from.y()}, {0.05, 0.05}, Mat2::Identity());
    }
  }
  // Every corner of a triangle, in each triangle that has it, to every other one in the plane.
  const auto& garment = squares.garment;
  const auto flat = [&](int t, int k) -> Vec2 {
    return garment.triangle_uv[t][k] + Vec2(garment.triangle_panel[t] == 1 ? 0.1 : 0, 0);
  };
  int refused = 0, wrong = 0, count = 0;
  for (std::size_t i = 0; i < garment.triangles.size(); i += 3)
    for (std::size_t j = 0; j < garment.triangles.size(); j += 7)
      for (int k = 0; k < 3; ++k) {
        const int from = static_cast<int>(i), to = static_cast<int>(j);
        const Vec2 shift = flat(to, k) - flat(from, k);
        const auto end = shifted(garment, {from, Vec3::Unit(k)}, shift);
        ++count;
        if (!end) {
          ++refused;
          continue;
        }
        const double out = panel_of(garment, end->point) == "b" ? 0.1 : 0;
        wrong += (pattern_place(garment, end->point) + Vec2(out, 0) - flat(to, k)).norm() > 1e-9;
      }
  EXPECT_GT(count, 10000);
  EXPECT_EQ(refused, 0);
  EXPECT_EQ(wrong, 0);
}

TEST(ShiftAlongCloth, EndsAtAFreeEdge) {
  const Squares squares(1, 3, false);
  const auto end = [&](const Vec2& from, const Vec2& shift) {
    return shifted(squares.garment, pattern_point(squares.garment, "a", from), shift);
  };
  EXPECT_TRUE(end({0.05, 0.05}, {0, 0.05009}));
  EXPECT_FALSE(end({0.05, 0.05}, {0, 0.05011}));
  EXPECT_FALSE(end({0.05, 0.05}, {0, 0.2}));
  EXPECT_FALSE(end({0.05, 0.05}, {-0.051, -0.051}));
  EXPECT_FALSE(end({0, 0.05}, {-0.001, 0}));
  // From one corner along the edges, and no farther.
  EXPECT_TRUE(end({0, 0}, {0.2, 0}));
  EXPECT_TRUE(end({0, 0}, {0, 0.1}));
  EXPECT_FALSE(end({0, 0}, {0, 0.101}));
  EXPECT_FALSE(end({0, 0}, {0.2011, 0}));
  // Slightly outwards: 0.05 mm on 0.2 m of hem lie within the tolerance, 0.2 mm do not.
  const auto slid = end({0, 0}, {0.15, -0.00005});
  ASSERT_TRUE(slid);
  EXPECT_LT((pattern_place(squares.garment, slid->point) - Vec2(0.05, 0)).norm(), 1e-6);
  EXPECT_FALSE(end({0, 0}, {0.15, -0.0002}));
  EXPECT_FALSE(end({0, 0}, {-0.00005, 0.12})) << "slides to the corner and ends there";
}

TEST(ShiftAlongCloth, GoesPastAHollowOfTheEdgeUpToTheTolerance) {
  const auto across = [](double hollow) {
    const garment::Garment garment =
        sewn({polygon_panel("a", {{0, 0}, {0.05, hollow}, {0.1, 0}, {0.1, 0.1}, {0, 0.1}})}, {});
    return shifted(garment, pattern_point(garment, "a", {0.005, 0}), {0.09, 0}).has_value();
  };
  EXPECT_TRUE(across(-0.01));
  EXPECT_TRUE(across(5e-5));
  EXPECT_FALSE(across(1e-3));
}

// A front with two straps: the cloth on the other side of the neckline is no place to come to.
TEST(ShiftAlongCloth, DoesNotLeapOverAGap) {
  const garment::Garment garment = sewn({polygon_panel("front", {{0, 0},
                                                                 {0.1, 0},
                                                                 {0.1, 0.1},
                                                                 {0.06, 0.1},
                                                                 {0.06, 0.06},
                                                                 {0.04, 0.06},
                                                                 {0.04, 0.1},
                                                                 {0, 0.1}})},
                                        {});
  const GarmentPoint strap = pattern_point(garment, "front", {0.03, 0.08});
  EXPECT_FALSE(shifted(garment, strap, {0.04, 0}));
  EXPECT_TRUE(shifted(garment, pattern_point(garment, "front", {0.03, 0.055}), {0.04, 0}));
}

/// Two squares of 0.1 m whose sewn sides, right of a and left of b, bulge by arcs of this radius.
garment::Garment curved_apart(double radius, double edge_length) {
  pattern::Panel a = rectangle_panel("a", 0.1, 0.1), b = rectangle_panel("b", 0.1, 0.1);
  for (pattern::PanelEdge* edge : {&a.edges[1], &b.edges[3]}) {
    edge->curves[0].kind = pattern::EdgeCurve::Kind::circle;
    edge->curves[0].radius = radius;
    edge->curves[0].sweep = true;
  }
  return sewn({a, b}, {stitch(0, 1, 1, 3)}, edge_length);
}

// A line that meets an arc at an angle to its tangent goes on at that angle to the other one.
TEST(ShiftAlongCloth, GoesOnBeyondASeamWhoseSidesCurveApart) {
  const double radius = 0.1;
  const garment::Garment garment = curved_apart(radius, 0.0025);
  const Vec2 centre_a(0.1 - std::sqrt(radius * radius - 0.0025), 0.05);
  const Vec2 centre_b(0.1 - centre_a.x(), 0.05);
  double worst = 0, worst_turn = 0;
  int count = 0;
  for (double v = 0.030; v < 0.070; v += 0.0013)
    for (const double lean : {-0.3, 0.0, 0.4}) {
      const Vec2 from(0.085, v), d(std::cos(lean), std::sin(lean));
      const Vec2 off = from - centre_a;
      const double way =
          -off.dot(d) + std::sqrt(off.dot(d) * off.dot(d) - off.squaredNorm() + radius * radius);
      const Vec2 out = (off + way * d) / radius;
      // The same height on both arcs. A turn by twice the slope of the tangent takes one to the
      // other.
      const double turn = -2 * std::asin(out.y());
      const Vec2 in_b = centre_b + radius * Vec2(-out.x(), out.y()) +
                        (0.04 - way) * (Eigen::Rotation2Dd(turn) * d);
      const auto end = shifted(garment, pattern_point(garment, "a", from), 0.04 * d);
      ++count;
      ASSERT_TRUE(end) << from.transpose() << ", " << lean;
      EXPECT_EQ(panel_of(garment, end->point), "b");
      worst = std::max(worst, (pattern_place(garment, end->point) - in_b).norm());
      worst_turn = std::max(worst_turn, std::abs(end->turn - turn));
    }
  EXPECT_GT(count, 80);
  // The tangent of chords of 2.5 mm is 12.5 mrad off on either side, over 30 mm of way.
  EXPECT_LT(worst_turn, 0.026);
  EXPECT_LT(worst, 0.8e-3);
}

// Wherever a line leads to on a shirt, the line back leads from there; and it is refused only where
// a free edge lies as near as that.
TEST(ShiftAlongCloth, LeadsBackOnAShirt) {
  const body::Body body = support::standing(support::adult_parameters(), 30);
  const garment::Garment shirt =
      garment::assemble(support::shirt_for(body, 0.12), 0.02, fabric::Material{});
  const TriangleNeighbours neighbours = triangle_neighbours(shirt);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(0, 1);
  int ended = 0, in_another = 0, refused = 0, lost = 0, beside = 0;
  for (int i = 0; i < 3000; ++i) {
    const int triangle = static_cast<int>(number(random) * shirt.triangles.size());
    Vec3 weights(number(random), number(random), number(random));
    const GarmentPoint from{triangle, weights / weights.sum()};
    const double length = 0.02 + 0.08 * number(random), lean = 2 * kPi * number(random);
    const Vec2 shift = length * axis_in_pattern(lean);
    const auto end = shifted(shirt, from, shift);
    if (!end) {
      ++refused;
      bool edge = false;
      for (const FlatTriangle& near :
           unfold(shirt, triangle, pattern_place(shirt, from), length, &neighbours))
        for (const int beyond : neighbours[near.triangle]) edge |= beyond < 0;
      EXPECT_TRUE(edge) << "no free edge within " << length;
      continue;
    }
    ++ended;
    in_another += panel_of(shirt, end->point) != panel_of(shirt, from);
    const auto back = shifted(shirt, end->point, -length * axis_in_pattern(end->angle(lean)));
    const double off = back && panel_of(shirt, back->point) == panel_of(shirt, from)
                           ? (pattern_place(shirt, back->point) - pattern_place(shirt, from)).norm()
                           : 1;
    lost += off > 1e-4;
    beside += off > 1e-6;
  }
  RecordProperty("refused", refused);
  EXPECT_GT(in_another, 500);
  EXPECT_GT(refused, 50);
  EXPECT_EQ(lost, 0) << "of " << ended;
  EXPECT_LE(beside, 5) << "those that grazed a free edge within the tolerance";
}

}  // namespace
}  // namespace loosefit::placement
