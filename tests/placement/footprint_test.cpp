#include "loosefit/placement/footprint.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/geometry/closest_point.h"
#include "support/tube_garment.h"

namespace loosefit {
namespace {

/// A wide tube opened to a plane strip in x–z, far from its seam.
struct Sheet {
  Garment garment = testing::tube_garment(0.4, 0.3, 53, 41);
  std::vector<Vec3> positions;
  Sheet() {
    for (const Vec2& uv : garment.vertex_uv) positions.emplace_back(uv.x(), 0, uv.y());
  }
  std::pair<int, Vec3> at(const Vec3& p) const {
    const TriangleMesh mesh{positions, garment.triangles};
    const ClosestPoint hit = ClosestPointTree(mesh).query(p);
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

}  // namespace
}  // namespace loosefit
