#include "loosefit/drape/cleft_cover.h"

#include <gtest/gtest.h>

#include "loosefit/geometry/closest_point_tree.h"
#include "loosefit/geometry/triangle_mesh.h"
#include "support/shapes.h"

namespace loosefit::drape {
namespace {

/// Two balls side by side with a cleft of this width between them, the crotch above it.
body::Body two_balls(double cleft) {
  body::Body body;
  const double radius = 0.1;
  for (const double side : {-1.0, 1.0}) {
    geometry::TriangleMesh ball = support::sphere(radius, 60, 120);
    const int first = static_cast<int>(body.surface.vertices.size());
    for (const Vec3& p : ball.vertices)
      body.surface.vertices.push_back(p + side * (radius + cleft / 2) * Vec3::UnitX());
    for (const Triangle& t : ball.triangles)
      body.surface.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  body.normals = geometry::vertex_normals(body.surface.vertices, body.surface.triangles);
  body.landmarks["crotch"] = Vec3(0, 0, 0.04);
  return body;
}

TEST(CleftCover, FillsWhatIsTooNarrowForClothAndNothingElse) {
  const geometry::TriangleMesh cover = cleft_cover(two_balls(0.002));
  ASSERT_FALSE(cover.triangles.empty());
  const geometry::ClosestPointTree tree(cover);
  EXPECT_LT(tree.signed_distance(Vec3::Zero()), -0.005);
  // Balls of 0.1 m are 8 mm from each other 25 mm off the line between their middles.
  EXPECT_GT(tree.signed_distance(Vec3(0, 0, 0.035)), 0);
  EXPECT_GT(tree.signed_distance(Vec3(0, 0.035, 0)), 0);
}

TEST(CleftCover, ThereIsNoneWhereClothHasRoomOrNoCrotchIsKnown) {
  EXPECT_TRUE(cleft_cover(two_balls(0.012)).triangles.empty());
  body::Body unknown = two_balls(0.002);
  unknown.landmarks.clear();
  EXPECT_TRUE(cleft_cover(unknown).triangles.empty());
}

}  // namespace
}  // namespace loosefit::drape
