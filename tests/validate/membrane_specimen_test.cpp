#include "loosefit/validate/membrane_specimen.h"

#include <gtest/gtest.h>

namespace loosefit::validate {
namespace {

TEST(Roughen, KeepsTheOutlineAndTheArea) {
  Specimen s = cut_rectangle(0.1, 0.12, 0.01, fabric::Material{});
  const std::vector<Vec2> before = s.vertex_uv;
  roughen(s, 0.01);
  double area = 0, moved = 0;
  for (const auto& [a, b, c] : s.triangle_uv) {
    const double twice = (b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0];
    EXPECT_GT(twice, 0);
    area += 0.5 * twice;
  }
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Vec2& p = before[i];
    const bool border = std::min({p[0], p[1], 0.1 - p[0], 0.12 - p[1]}) < 1e-9;
    if (border) {
      EXPECT_EQ(p, s.vertex_uv[i]);
    }
    moved = std::max(moved, (p - s.vertex_uv[i]).norm());
  }
  EXPECT_NEAR(area, 0.012, 1e-12);
  EXPECT_GT(moved, 0.002);
}

}  // namespace
}  // namespace loosefit::validate
