#include "loosefit/placement/footprint.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/garment/assemble.h"
#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/placement/footprint_unfold.h"
#include "support/simple_patterns.h"
#include "support/tube_garment.h"

namespace loosefit::placement {
namespace {

/// A wide tube opened to a plane strip in x–z, far from its seam.
struct Sheet {
  garment::Garment garment = testing::tube_garment(0.4, 0.3, 53, 41);
  std::vector<Vec3> positions;
  Sheet() {
    for (const Vec2& uv : garment.vertex_uv) positions.emplace_back(uv.x(), 0, uv.y());
  }
  std::pair<int, Vec3> at(const Vec3& p) const {
    const geometry::TriangleMesh mesh{positions, garment.triangles};
    const geometry::ClosestPoint hit = geometry::ClosestPointTree(mesh).query(p);
    return {hit.triangle, hit.barycentric};
  }
};

TEST(Footprint, CoversTheDisc) {
  const Sheet sheet;
  const auto [triangle, weights] = sheet.at({0.2, 0, 0.15});
  const Footprint patch = footprint(sheet.garment, sheet.positions, triangle, weights, 0.02);
  double area = 0;
  for (const auto& s : patch.samples) area += s.area;
  EXPECT_NEAR(area, kPi * 0.02 * 0.02, 0.02 * kPi * 0.02 * 0.02);
}

TEST(Footprint, MeanOfALinearFieldIsItsCentre) {
  const Sheet sheet;
  std::vector<double> field;
  for (const Vec3& p : sheet.positions) field.push_back(3 * p.x() - 2 * p.z());
  const auto [triangle, weights] = sheet.at({0.2, 0, 0.15});
  const FootprintValue value = average(
      footprint(sheet.garment, sheet.positions, triangle, weights, 0.02), sheet.garment, field);
  EXPECT_NEAR(value.mean, 0.3, 1e-3);
  // 5 % of a disc lie beyond 0.8054 r in any direction (circular segment).
  EXPECT_NEAR(value.worst, 0.3 + std::sqrt(13.0) * 0.8054 * 0.02, 2e-3);
}

TEST(Footprint, UndefinedVerticesArePassedOver) {
  const Sheet sheet;
  std::vector<double> field(sheet.positions.size(), 5.0);
  const auto [triangle, weights] = sheet.at({0.2, 0, 0.15});
  field[sheet.garment.triangles[triangle][0]] = std::nan("");
  EXPECT_NEAR(average(footprint(sheet.garment, sheet.positions, triangle, weights, 0.02),
                      sheet.garment, field)
                  .mean,
              5.0, 1e-12);
}

TEST(Footprint, TheNextFoldLayerDoesNotCount) {
  // The strip folded over at x = 0.2: the second layer lies 2 mm behind the first.
  Sheet sheet;
  for (Vec3& p : sheet.positions)
    if (p.x() > 0.2) p = Vec3(0.4 - p.x(), 0.002, p.z());
  std::vector<double> field;
  for (const Vec3& p : sheet.positions) field.push_back(p.y() > 0 ? 100 : 1);
  const auto [triangle, weights] = sheet.at({0.1, 0, 0.15});
  EXPECT_NEAR(average(footprint(sheet.garment, sheet.positions, triangle, weights, 0.02),
                      sheet.garment, field)
                  .worst,
              1, 1e-12);
}

TEST(Footprint, SmallerThanATriangleIsThePointItself) {
  const Sheet sheet;
  const auto [triangle, weights] = sheet.at({0.2, 0, 0.15});
  EXPECT_FALSE(footprint(sheet.garment, sheet.positions, triangle, weights, 1e-9).samples.empty());
}

FootprintShape rectangle(double across, double along) {
  FootprintShape shape;
  shape.kind = FootprintShape::Kind::rectangle;
  shape.size = {across, along};
  return shape;
}

FootprintShape line(double length) {
  FootprintShape shape;
  shape.kind = FootprintShape::Kind::line;
  shape.length = length;
  return shape;
}

double total(const Footprint& patch) {
  double area = 0;
  for (const auto& s : patch.samples) area += s.area;
  return area;
}

Vec3 point(const Sheet& sheet, const Footprint::Sample& s) {
  Vec3 p = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
    p += s.barycentric[k] * sheet.positions[sheet.garment.triangles[s.triangle][k]];
  return p;
}

TEST(Footprint, RectangleLiesAlongItsAxis) {
  const Sheet sheet;
  const auto [triangle, weights] = sheet.at({0.2, 0, 0.15});
  // Axis 30° from the warp (z), counter-clockwise in the pattern: towards −u (−x).
  const double a = radians(30.0);
  const Footprint patch =
      footprint(sheet.garment, sheet.positions, triangle, weights, rectangle(0.02, 0.06), a);
  EXPECT_NEAR(total(patch), 0.02 * 0.06, 0.02 * 0.02 * 0.06);
  const Vec3 along(-std::sin(a), 0, std::cos(a)), across(std::cos(a), 0, std::sin(a));
  double spread_along = 0, spread_across = 0;
  for (const auto& s : patch.samples) {
    const Vec3 off = point(sheet, s) - Vec3(0.2, 0, 0.15);
    spread_along += s.area * std::pow(off.dot(along), 2);
    spread_across += s.area * std::pow(off.dot(across), 2);
  }
  // Second moments of a rectangle: a b³ / 12.
  EXPECT_NEAR(spread_along, 0.02 * std::pow(0.06, 3) / 12, 0.03 * 0.02 * std::pow(0.06, 3) / 12);
  EXPECT_NEAR(spread_across, 0.06 * std::pow(0.02, 3) / 12, 0.06 * 0.06 * std::pow(0.02, 3) / 12);
}

TEST(Footprint, LineSharesItsLength) {
  const Sheet sheet;
  const auto [triangle, weights] = sheet.at({0.2, 0, 0.15});
  const double a = radians(-45.0);
  const Footprint patch =
      footprint(sheet.garment, sheet.positions, triangle, weights, line(0.05), a);
  EXPECT_NEAR(total(patch), 0.05, 1e-12);
  std::vector<double> field;
  for (const Vec3& p : sheet.positions) field.push_back(p.x());
  const FootprintValue value = average(patch, sheet.garment, field);
  EXPECT_NEAR(value.mean, 0.2, 1e-9);
  EXPECT_NEAR(value.worst, 0.2 + 0.45 * 0.05 * std::sqrt(0.5), 1e-3);
  for (const auto& s : patch.samples) {
    const Vec3 off = point(sheet, s) - Vec3(0.2, 0, 0.15);
    EXPECT_NEAR(off.x(), off.z(), 1e-9);
  }
}

TEST(Footprint, WhatWouldLieBeyondTheHemIsLeftOut) {
  const Sheet sheet;
  const auto [triangle, weights] = sheet.at({0.2, 0, 0});
  EXPECT_NEAR(
      total(footprint(sheet.garment, sheet.positions, triangle, weights, rectangle(0.03, 0.05), 0)),
      0.03 * 0.025, 0.03 * 0.03 * 0.025);
  EXPECT_NEAR(total(footprint(sheet.garment, sheet.positions, triangle, weights, line(0.05), 0)),
              0.025, 1e-9);
}

/// The tube sewn and worn: its seam is at u = 0 and u = 0.4.
struct Tube {
  garment::Garment garment = testing::tube_garment(0.4, 0.3, 53, 41);
  std::vector<Vec3> positions;
  Tube() {
    const double r = 0.4 / (2 * kPi);
    for (const Vec2& uv : garment.vertex_uv)
      positions.emplace_back(r * std::cos(uv.x() / r), r * std::sin(uv.x() / r), uv.y());
  }
};

TEST(Footprint, GoesOnBeyondASeam) {
  const Tube tube;
  int triangle = -1;  // first one right of the seam, half way up
  for (int t = 0; t < static_cast<int>(tube.garment.triangles.size()) && triangle < 0; ++t)
    if (tube.garment.triangle_uv[t][0].x() == 0 && tube.garment.triangle_uv[t][0].y() > 0.14)
      triangle = t;
  const Vec3 corner(1, 0, 0);
  const double v = tube.garment.triangle_uv[triangle][0].y();
  EXPECT_NEAR(total(footprint(tube.garment, tube.positions, triangle, corner, 0.02)),
              kPi * 0.02 * 0.02, 0.03 * kPi * 0.02 * 0.02);
  // A line of 60 mm that leans by 60°: half of it on the other side, straight on.
  const double a = radians(-60.0);
  const Footprint band = footprint(tube.garment, tube.positions, triangle, corner, line(0.06), a);
  EXPECT_NEAR(total(band), 0.06, 1e-9);
  double beyond = 0;
  for (const auto& s : band.samples) {
    Vec2 uv = Vec2::Zero();
    for (int k = 0; k < 3; ++k) uv += s.barycentric[k] * tube.garment.triangle_uv[s.triangle][k];
    if (uv.x() > 0.2) uv.x() -= 0.4, beyond += s.area;
    EXPECT_NEAR((uv.y() - v) / uv.x(), std::tan(radians(30.0)), 1e-6);
  }
  EXPECT_NEAR(beyond, 0.03, 0.001);
}

TEST(Footprint, APieceSewnRightToWrongIsTurnedOver) {
  // Two squares drawn alike, the right edges of both sewn start to start: the second lies turned
  // over on the other side of the seam.
  pattern::Pattern pattern;
  pattern.panels = {testing_support::rectangle_panel("a", 0.1, 0.1),
                    testing_support::rectangle_panel("b", 0.1, 0.1)};
  pattern.stitches = {testing_support::stitch(0, 1, 1, 1, true)};
  const garment::Garment garment = garment::assemble(pattern, 0.01, {});
  const std::vector<Vec3> flat(garment.vertex_count, Vec3::Zero());
  geometry::ClosestPoint start;
  for (int t = 0; t < static_cast<int>(garment.triangles.size()); ++t) {
    if (garment.triangle_panel[t] != 0) continue;
    const Vec3 w = weights_in(garment.triangle_uv[t], {0.09, 0.05});
    if (w.minCoeff() >= 0) start.triangle = t, start.barycentric = w;
  }
  ASSERT_GE(start.triangle, 0);
  // 30° up to the right: reaches (0.1, 0.0558) at the seam; beyond it x counts back.
  const Footprint thread =
      footprint(garment, flat, start.triangle, start.barycentric, line(0.06), radians(-60.0));
  EXPECT_NEAR(total(thread), 0.06, 1e-9);
  int beyond = 0;
  for (const auto& s : thread.samples) {
    if (garment.triangle_panel[s.triangle] != 1) continue;
    ++beyond;
    Vec2 uv = Vec2::Zero();
    for (int k = 0; k < 3; ++k) uv += s.barycentric[k] * garment.triangle_uv[s.triangle][k];
    EXPECT_NEAR(uv.y(), 0.05 + (0.2 - uv.x() - 0.09) * std::tan(radians(30.0)), 1e-6);
  }
  EXPECT_NEAR(beyond, 18, 1);  // of 60 samples, (0.03 - 0.01 / cos 30°) / 0.001
}

TEST(Footprint, GirthIsTheLevelLineOfItsOwnLoop) {
  const Tube tube;
  // The tube is cut by a plane tilted by 20°: an ellipse, developed in the pattern.
  const double tilt = radians(20.0);
  const Vec3 normal(-std::sin(tilt), 0, std::cos(tilt));
  const int triangle = 53 * 41;  // somewhere half way up
  const Footprint girth =
      girth_footprint(tube.garment, tube.positions, triangle, Vec3::Constant(1.0 / 3), normal);
  double perimeter = 0;  // ∫ sqrt(1 + (dz/ds)²) ds with z = x tan(tilt)
  for (int i = 0; i < 3600; ++i)
    perimeter += 0.4 / 3600 * std::hypot(1.0, std::tan(tilt) * std::sin(radians(0.1 * (i + 0.5))));
  EXPECT_NEAR(total(girth), perimeter, 2e-3 * perimeter);
  EXPECT_THROW(girth_footprint(tube.garment, tube.positions, triangle, Vec3(1, 0, 0), Vec3::Zero()),
               InvalidInput);
  FootprintShape all_round;
  all_round.kind = FootprintShape::Kind::girth;
  EXPECT_THROW(footprint(tube.garment, tube.positions, triangle, Vec3(1, 0, 0), all_round, 0),
               InvalidInput);
}

}  // namespace
}  // namespace loosefit::placement
