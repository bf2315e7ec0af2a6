#include "loosefit/render/clipped_surface.h"

#include <gtest/gtest.h>

namespace loosefit::render {
namespace {

TEST(Clipped, SplitsTrianglesAtTheCut) {
  const geometry::TriangleMesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const ClippedSurface cut = clipped(one, {0.25, -0.75, 0.25});
  const geometry::TriangleMesh& part = cut.mesh;
  double area = 0;
  for (const Triangle& t : part.triangles)
    area += geometry::triangle_area(part.vertices[t[0]], part.vertices[t[1]], part.vertices[t[2]]);
  EXPECT_NEAR(area, 0.5 - 0.5 * 0.75 * 0.75, 1e-12);
  ASSERT_EQ(cut.rim.size(), 1u);
  for (const int v : cut.rim[0]) EXPECT_NEAR(part.vertices[v].x(), 0.25, 1e-12);
  for (std::size_t v = 0; v < part.vertices.size(); ++v) EXPECT_NE(cut.origin[v], 1);
  EXPECT_TRUE(clipped(one, {-1, -1, -1}).mesh.triangles.empty());
  EXPECT_EQ(clipped(one, {1, 1, 1}).mesh.triangles.size(), 1u);
}

}  // namespace
}  // namespace loosefit::render
