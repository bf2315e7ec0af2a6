#include "loosefit/io/svg/svg_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/base/error.h"

namespace loosefit::io {
namespace {

std::vector<SvgRun> path(const std::string& d) { return parse_svg_path(d, "p.svg", 7); }

double length(const SvgRun& run) {
  const SampledRun line = sampled(run, 1e-6);
  double sum = 0;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
    sum += (line.points[i + 1] - line.points[i]).norm();
  if (line.closed) sum += (line.points.front() - line.points.back()).norm();
  return sum;
}

void expect_same(const std::string& a, const std::string& b) {
  const auto one = path(a), two = path(b);
  ASSERT_EQ(one.size(), two.size()) << a;
  for (std::size_t r = 0; r < one.size(); ++r) {
    ASSERT_EQ(one[r].segments.size(), two[r].segments.size()) << a;
    EXPECT_EQ(one[r].closed, two[r].closed) << a;
    EXPECT_LT((one[r].start - two[r].start).norm(), 1e-12) << a;
    for (std::size_t s = 0; s < one[r].segments.size(); ++s) {
      EXPECT_LT((one[r].segments[s].to - two[r].segments[s].to).norm(), 1e-9) << a;
      EXPECT_LT((one[r].segments[s].first - two[r].segments[s].first).norm(), 1e-9) << a;
      EXPECT_LT((one[r].segments[s].second - two[r].segments[s].second).norm(), 1e-9) << a;
    }
  }
}

TEST(SvgPath, RelativeAndAbsoluteCommandsSayTheSame) {
  expect_same("M1,2 l3 4 h5 v6 z", "M 1 2 L 4 6 H 9 V 12 Z");
  expect_same("m1,2 3 4 5 6", "M1 2L4 6 9 12");  // what follows a move are lines
  expect_same("M10 10c1-2 3-4 5-6s7-8 9-10", "M10,10C11,8,13,6,15,4 S22-4 24-6");
  expect_same("M10 10q5 5 10 0t10 0", "M10 10 Q15 15 20 10 T30 10");
  expect_same("M0 0a5 5 0 0 1 10 0", "M0 0A5,5,0,0,1,10,0");
  expect_same("M0 0a5 5 0 0110 0", "M0 0A5 5 0 0 1 10 0");  // flags may touch
  expect_same("M.5.5 1.5e1-.25", "M 0.5 0.5 L 15 -0.25");
  expect_same("M0 0 1 0 1 1z m5 5 1 0", "M0 0L1 0 1 1Z M5 5 L6 5");  // from where it was closed
  expect_same("M1 1 L2 1 L2 2 Z L3 3", "M1 1 L2 1 L2 2 Z M1 1 L3 3");
}

TEST(SvgPath, ReflectsControlPointsOnlyBehindCurvesOfTheSameKind) {
  expect_same("M0 0 S1 1 2 0", "M0 0 C0 0 1 1 2 0");
  expect_same("M0 0 Q1 1 2 0 L4 0 T6 0", "M0 0 Q1 1 2 0 L4 0 Q4 0 6 0");
}

TEST(SvgPath, ArcsHaveTheLengthOfCirclesAndEllipses) {
  EXPECT_NEAR(length(path("M0 0 A50 50 0 0 1 100 0")[0]), 50 * kPi, 1e-4);
  EXPECT_NEAR(length(path("M0 0 A50 50 0 1 1 50 50")[0]), 1.5 * kPi * 50, 1e-4);
  EXPECT_NEAR(length(path("M0 0 A50 50 0 0 0 50 50")[0]), 0.5 * kPi * 50, 1e-4);
  // Radii that are too small grow until the arc reaches (SVG 1.1, F.6.6).
  EXPECT_NEAR(length(path("M0 0 A1 1 0 0 1 100 0")[0]), 50 * kPi, 1e-4);
  EXPECT_NEAR(length(path("M0 0 A0 1 0 0 1 100 0")[0]), 100, 1e-9);
  // Clockwise on the page, y down: the sweep flag 1 goes through negative y from left to right.
  const SampledRun over = sampled(path("M0 0 A50 50 0 0 1 100 0")[0], 0.01);
  EXPECT_NEAR(over.points[over.points.size() / 2].y(), -50, 0.5);
  EXPECT_NEAR(length(svg_ellipse({3, 4}, {10, 10})), 20 * kPi, 1e-4);
  EXPECT_NEAR(length(svg_rectangle({0, 0}, {30, 20}, {5, 5})), 60 + 10 * kPi, 1e-4);
}

TEST(SvgPath, ChordsStayWithinTheToleranceOfACurve) {
  const SampledRun line = sampled(path("M0 0 A200 200 0 0 1 200 200")[0], 0.01);
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const Vec2 middle = (line.points[i] + line.points[i + 1]) / 2;
    EXPECT_NEAR((middle - Vec2(0, 200)).norm(), 200, 0.011);
  }
  EXPECT_LT(line.points.size(), 300u);
}

TEST(SvgPath, TransformsAreAppliedFromTheLeft) {
  const auto at = [](const std::string& t, const Vec2& p) -> Vec2 {
    return parse_svg_transform(t, "p.svg", 7) * p;
  };
  EXPECT_LT((at("translate(10 20) scale(2)", {1, 1}) - Vec2(12, 22)).norm(), 1e-12);
  EXPECT_LT((at("rotate(90)", {1, 0}) - Vec2(0, 1)).norm(), 1e-12);
  EXPECT_LT((at("rotate(90, 1, 1)", {2, 1}) - Vec2(1, 2)).norm(), 1e-12);
  EXPECT_LT((at("matrix(1,2,3,4,5,6)", {1, 1}) - Vec2(9, 12)).norm(), 1e-12);
  EXPECT_LT((at("skewX(45)", {0, 1}) - Vec2(1, 1)).norm(), 1e-12);
  EXPECT_LT((at("scale(2, -1)translate(3)", {0, 1}) - Vec2(6, -1)).norm(), 1e-12);
}

TEST(SvgPath, WhatIsNoPathIsToldWithItsCharacter) {
  const auto told = [](const std::string& d, const std::string& words) {
    try {
      path(d);
      ADD_FAILURE() << d;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).rfind("p.svg:7: d:", 0), 0u) << error.what();
    }
  };
  told("L1 2", "M, with which paths begin");
  told("M1", "at character 3");
  told("M1 2 X3", "not X");
  told("M1 2 A1 1 0 2 0 3 3", "a flag, 0 or 1");
  told("M1 1e999", "a number");
  told("M1 nan", "a number");
  EXPECT_THROW(parse_svg_transform("rotate(1,2)", "p.svg", 7), InvalidInput);
  EXPECT_THROW(parse_svg_transform("translate(1", "p.svg", 7), InvalidInput);
  EXPECT_THROW(parse_svg_transform("scale(1e7) scale(1e7)", "p.svg", 7), InvalidInput);
}

}  // namespace
}  // namespace loosefit::io
