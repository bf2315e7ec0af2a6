#include "loosefit/drape/worn_detail.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace loosefit::drape {
namespace {

constexpr int kSide = 5;

/// A plane grid of 10 mm, and the same with a bump of 3 mm.
struct Sheet {
  std::vector<Vec3> flat, bumpy;
  std::vector<Triangle> triangles;
  Sheet() {
    for (int j = 0; j < kSide; ++j)
      for (int i = 0; i < kSide; ++i) {
        flat.push_back(0.01 * Vec3(i, j, 0));
        bumpy.push_back(flat.back() + Vec3(0, 0, i == 2 && j == 2 ? 0.003 : 0));
        const int v = j * kSide + i;
        if (i + 1 == kSide || j + 1 == kSide) continue;
        triangles.push_back({v, v + 1, v + kSide});
        triangles.push_back({v + 1, v + kSide + 1, v + kSide});
      }
  }
};

TEST(OnCoarseSurface, KeepsVerticesAndHalvesEdges) {
  const auto fine = on_coarse_surface({{0, 0}, {1, 1}, {0, 1}}, {Vec3(0, 0, 2), Vec3(4, 0, 0)});
  EXPECT_EQ(fine[1], Vec3(4, 0, 0));
  EXPECT_EQ(fine[2], Vec3(2, 0, 1));
}

TEST(TurnedDetail, TurnsWithAMovedSheet) {
  const Sheet sheet;
  const Mat3 turn = Eigen::AngleAxisd(2.0, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  std::vector<Vec3> now;
  for (const Vec3& p : sheet.flat) now.push_back(turn * p + Vec3(0.3, 0, 1));
  const auto detail = turned_detail(sheet.triangles, sheet.flat, sheet.bumpy, now);
  for (std::size_t i = 0; i < now.size(); ++i)
    EXPECT_LT((detail[i] - turn * (sheet.bumpy[i] - sheet.flat[i])).norm(), 1e-12);
}

TEST(TurnedDetail, StandsOnASheetThatWasBentAndStretched) {
  const Sheet sheet;
  std::vector<Vec3> now;  // a quarter of a cylinder about y, a tenth wider
  const double radius = 0.04 / (0.5 * kPi);
  for (const Vec3& p : sheet.flat) {
    const double a = p.x() / radius;
    now.push_back(Vec3(1.1 * radius * std::sin(a), 1.1 * p.y(), 1.1 * radius * (std::cos(a) - 1)));
  }
  const auto detail = turned_detail(sheet.triangles, sheet.flat, sheet.bumpy, now);
  const int top = 2 * kSide + 2;  // half way round: the normal leans by 45°
  const Vec3 normal(std::sqrt(0.5), 0, std::sqrt(0.5));
  EXPECT_NEAR(detail[top].norm(), 0.003, 1e-12) << "turned, not stretched";
  EXPECT_GT(detail[top].dot(normal) / 0.003, std::cos(radians(3)));
}

}  // namespace
}  // namespace loosefit::drape
