#include "loosefit/flesh/soft_skin.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/geometry/exact_intersection.h"
#include "support/shapes.h"

namespace loosefit::flesh {
namespace {

/// Two balls of radius 80 mm, the second `gap` to the right of the first.
struct TwoBalls {
  geometry::TriangleMesh ball;
  SkinPatch patch;
  int first_count = 0;
  particles::VectorField at(double gap) const {
    particles::VectorField x;
    for (const Vec3& p : ball.vertices) x.push_back(p);
    for (const Vec3& p : ball.vertices) x.push_back(p + Vec3(0.16 + gap, 0, 0));
    return x;
  }
  explicit TwoBalls(int rings = 40) : ball(support::sphere(0.08, rings, 2 * rings)) {
    first_count = static_cast<int>(ball.vertices.size());
    for (int side = 0; side < 2; ++side)
      for (Triangle t : ball.triangles) {
        for (int& v : t) v += side * first_count;
        patch.triangles.push_back(t);
      }
    for (int v = 0; v < 2 * first_count; ++v) patch.vertex.push_back(v);
    patch.on_rim.assign(patch.vertex.size(), false);
  }
};

TEST(SoftSkin, WhatMeetsNothingGoesWithItsTargets) {
  const TwoBalls balls(80);  // edges of 3 mm: neighbours are nearer than folds may come
  SoftSkin skin(balls.patch, balls.at(0.05), balls.at(0.05), balls.at(0.05));
  skin.follow(balls.at(0.02));
  const particles::VectorField wanted = balls.at(0.02);
  for (std::size_t i = 0; i < wanted.size(); ++i)
    EXPECT_LT((skin.positions()[i] - wanted[i]).norm(), 1e-12);
}

TEST(SoftSkin, BothSidesGiveWayAlikeAndNothingPassesThrough) {
  const TwoBalls balls;
  SoftSkin skin(balls.patch, balls.at(0.05), balls.at(0.05), balls.at(0.05));
  for (double gap : {0.02, -0.01, -0.02}) skin.follow(balls.at(gap));
  const particles::VectorField& x = skin.positions();
  EXPECT_TRUE(geometry::self_intersections(x, balls.patch.triangles).empty());
  double left = -1, right = 1;  // where the line through both centres leaves one, enters the other
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::hypot(x[i][1], x[i][2]) > 0.004) continue;
    const bool first = static_cast<int>(i) < balls.first_count;
    if (first) left = std::max(left, x[i][0]);
    if (!first) right = std::min(right, x[i][0]);
  }
  EXPECT_GT(right - left, 0.7 * body::kSkinGap);
  EXPECT_LT(right - left, body::kSkinGap);
  EXPECT_NEAR(0.08 - left, right - (0.08 - 0.02), 1e-4);
}

}  // namespace
}  // namespace loosefit::flesh
