#include "loosefit/pattern/outline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/pattern/curve.h"
#include "loosefit/pattern/self_crossing.h"
#include "support/simple_patterns.h"

namespace loosefit::pattern {
namespace {

using namespace testing_support;

EdgeCurve quadratic(const Vec2& c) {
  EdgeCurve curve;
  curve.kind = EdgeCurve::Kind::quadratic;
  curve.control = {c};
  return curve;
}

EdgeCurve cubic(const Vec2& c1, const Vec2& c2) {
  EdgeCurve curve;
  curve.kind = EdgeCurve::Kind::cubic;
  curve.control = {c1, c2};
  return curve;
}

EdgeCurve circle(double radius, bool large, bool sweep) {
  EdgeCurve curve;
  curve.kind = EdgeCurve::Kind::circle;
  curve.radius = radius;
  curve.large_arc = large;
  curve.sweep = sweep;
  return curve;
}

const Vec2 kA(0, 0), kB(2, 0);

TEST(Curve, QuadraticLengthMatchesItsClosedForm) {
  // y = x - x²/2 on [0, 2] is the quadratic with control point (1, 1).
  const double expected = std::sqrt(2) + std::asinh(1);
  EXPECT_NEAR(curve_length(quadratic({1, 1}), kA, kB), expected, 1e-12);
}

TEST(Curve, CircleFlagsAreThoseOfAnSvgArcWithYUp) {
  // Half circle: sweep runs counter-clockwise, from (0,0) to (2,0) that is below the chord.
  EXPECT_NEAR(curve_point(circle(1, false, true), kA, kB, .5).y(), -1, 1e-12);
  EXPECT_NEAR(curve_point(circle(1, false, false), kA, kB, .5).y(), 1, 1e-12);
  const double r = 2 / std::sqrt(3.0);  // chord 2: the short arc spans 120°
  EXPECT_NEAR(curve_length(circle(r, false, true), kA, kB), r * radians(120), 1e-12);
  EXPECT_NEAR(curve_length(circle(r, true, true), kA, kB), r * radians(240), 1e-12);
  EXPECT_NEAR(curve_point(circle(r, false, true), kA, kB, .5).y(), -r / 2, 1e-12);
  EXPECT_NEAR(curve_point(circle(r, true, true), kA, kB, .5).y(), -1.5 * r, 1e-12);
  EXPECT_NEAR(curve_point(circle(r, true, false), kA, kB, .5).y(), 1.5 * r, 1e-12);
  // Too small a radius is enlarged to the half circle.
  EXPECT_NEAR(curve_length(circle(.1, false, true), kA, kB), kPi, 1e-12);
}

TEST(Curve, SplitReverseAndMirrorKeepTheShape) {
  for (const EdgeCurve& c : {EdgeCurve{}, quadratic({.4, 1.3}), cubic({.1, .8}, {2.5, -.6}),
                             circle(1.2, true, false), circle(1.7, false, true)}) {
    const double cut = .3;
    const auto [left, right] = split_curve(c, kA, kB, cut);
    const Vec2 knot = curve_point(c, kA, kB, cut);
    EXPECT_NEAR(curve_length(left, kA, knot) + curve_length(right, knot, kB),
                curve_length(c, kA, kB), 1e-12);
    for (const double t : {.1, .5, .8}) {
      EXPECT_LT((curve_point(left, kA, knot, t) - curve_point(c, kA, kB, cut * t)).norm(), 1e-12);
      EXPECT_LT(
          (curve_point(right, knot, kB, t) - curve_point(c, kA, kB, cut + (1 - cut) * t)).norm(),
          1e-12);
      EXPECT_LT((curve_point(reversed_curve(c), kB, kA, t) - curve_point(c, kA, kB, 1 - t)).norm(),
                1e-12);
      const Vec2 image = curve_point(mirrored_curve(c), -kA, -kB, t);
      const Vec2 original = curve_point(c, kA, kB, t);
      EXPECT_LT((image - Vec2(-original.x(), original.y())).norm(), 1e-12);
      const double e = 1e-6;
      const Vec2 difference =
          (curve_point(c, kA, kB, t + e) - curve_point(c, kA, kB, t - e)) / (2 * e);
      EXPECT_LT((difference - curve_derivative(c, kA, kB, t)).norm(), 1e-8);
    }
  }
}

TEST(EdgePath, FractionsAreEvenInArcLengthAcrossJoints) {
  Panel panel = rectangle_panel("p", 2, 1);
  PanelEdge& edge = panel.edges[0];
  edge.curves = {cubic({.1, .9}, {.2, -.7}), quadratic({1.5, 0.8}), EdgeCurve{}};
  edge.knots = {{.8, 0}, {1.7, .1}};
  const EdgePath path(panel, 0);
  EXPECT_EQ(path.at(0), panel.vertices[0]);
  EXPECT_EQ(path.at(1), panel.vertices[1]);
  const auto joints = path.joint_fractions();
  ASSERT_EQ(joints.size(), 2u);
  const int n = 20000;
  double walked = 0;
  for (int i = 0; i < n; ++i) {
    const double step = (path.at((i + 1.0) / n) - path.at(double(i) / n)).norm();
    walked += step;
    // A step across a kink is cut short.
    if (std::floor(joints[0] * n) == i || std::floor(joints[1] * n) == i) continue;
    EXPECT_NEAR(step, path.length() / n, 1e-4 * path.length() / n) << i;
  }
  EXPECT_NEAR(walked, path.length(), 2.0 * path.length() / n);
  EXPECT_LT((path.at(joints[0]) - edge.knots[0]).norm(), 1e-9);
  EXPECT_LT((path.at(joints[1]) - edge.knots[1]).norm(), 1e-9);
}

TEST(Polygon, SelfCrossingIsFound) {
  const auto crosses = [](const std::vector<Vec2>& p) { return first_self_crossing(p).first >= 0; };
  EXPECT_FALSE(crosses({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_TRUE(crosses({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));
  EXPECT_TRUE(crosses({{0, 0}, {2, 0}, {1, 0}, {1, 1}})) << "folds back";
  EXPECT_TRUE(crosses({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}})) << "touches";
  EXPECT_TRUE(crosses({{0, 0}, {1, 0}, {1, 0}, {0, 1}})) << "repeated point";
}

TEST(Polygon, InsideAndNearest) {
  const std::vector<Vec2> ell{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  EXPECT_TRUE(inside_polygon(ell, {.5, 1.5}));
  EXPECT_FALSE(inside_polygon(ell, {1.5, 1.5}));
  EXPECT_NEAR(signed_area(ell), 3, 1e-15);
  EXPECT_LT((closest_on_polygon(ell, {1.5, 1.2}) - Vec2(1.5, 1)).norm(), 1e-15);
}

}  // namespace
}  // namespace loosefit::pattern
