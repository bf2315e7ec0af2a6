#include "loosefit/geometry/mesh_topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "support/shapes.h"

namespace loosefit::geometry {
namespace {

/// Two triangles of a square 0 1 2 3 (diagonal 0–2) and one more beyond the edge 1–2.
const std::vector<Triangle> kFlap = {{0, 1, 2}, {0, 2, 3}, {2, 1, 4}};

TEST(MeshTopology, EdgesAndTheirSidesAreThoseOfAPlainMap) {
  const auto triangles = support::sphere(0.1, 6, 9).triangles;
  std::map<std::array<int, 2>, std::vector<std::pair<int, int>>> plain;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
      plain[{low, high}].emplace_back(t, k);
    }
  const MeshTopology topology(triangles);
  ASSERT_EQ(topology.edges().size(), plain.size());
  int e = 0;
  for (const auto& [edge, sides] : plain) {
    EXPECT_EQ(topology.edges()[e], edge);
    EXPECT_EQ(topology.find(edge[1], edge[0]), e);
    ASSERT_EQ(topology.sides(e).size(), sides.size());
    for (std::size_t i = 0; i < sides.size(); ++i) {
      EXPECT_EQ(topology.sides(e)[i].triangle, sides[i].first);
      EXPECT_EQ(topology.sides(e)[i].corner, sides[i].second);
      EXPECT_EQ(topology.edge(sides[i].first, sides[i].second), e);
    }
    ++e;
  }
}

TEST(MeshTopology, AClosedSurfaceObeysEulerAndHasNoBorder) {
  const TriangleMesh ball = support::sphere(0.1, 6, 9);
  const MeshTopology topology(ball.triangles);
  EXPECT_EQ(static_cast<int>(ball.vertices.size()) - topology.edge_count() +
                static_cast<int>(ball.triangles.size()),
            2);
  EXPECT_TRUE(topology.boundary_loops().empty());
}

TEST(MeshTopology, KnowsNeighboursAndTheBorderInItsDirection) {
  const MeshTopology topology(kFlap);
  EXPECT_EQ(topology.vertex_neighbours(),
            (std::vector<std::vector<int>>{{1, 2, 3}, {0, 2, 4}, {0, 1, 3, 4}, {0, 2}, {1, 2}}));
  EXPECT_EQ(topology.boundary_loops(), (std::vector<std::vector<int>>{{0, 1, 4, 2, 3}}));
  EXPECT_EQ(topology.find(3, 1), -1);
  EXPECT_EQ(topology.find(0, 9), -1);
  EXPECT_EQ(topology.find(9, 12), -1);
}

TEST(MeshTopology, MoreThanTwoTrianglesMayMeetAtAnEdge) {
  const MeshTopology topology({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  const auto sides = topology.sides(topology.find(0, 1));
  ASSERT_EQ(sides.size(), 3u);
  for (int t = 0; t < 3; ++t) EXPECT_EQ(sides[t].triangle, t);
}

TEST(MeshTopology, BordersThatTouchInAVertexAreTwoLoops) {
  const MeshTopology topology({{0, 1, 2}, {0, 3, 4}});
  EXPECT_EQ(topology.boundary_loops(), (std::vector<std::vector<int>>{{0, 1, 2}, {0, 3, 4}}));
}

TEST(MeshTopology, OfNothingIsEmpty) {
  const MeshTopology topology({});
  EXPECT_EQ(topology.edge_count(), 0);
  EXPECT_TRUE(topology.boundary_loops().empty());
  EXPECT_TRUE(topology.vertex_neighbours().empty());
}

TEST(MeshTopology, CountsTheSidesOfRepeatedAndDegenerateTriangles) {
  const MeshTopology topology({{0, 1, 2}, {1, 0, 2}, {3, 3, 4}});
  const std::vector<MeshTopology::Edge> edges = {{0, 1}, {0, 2}, {1, 2}, {3, 3}, {3, 4}};
  EXPECT_EQ(topology.edges(), edges);
  for (int e = 0; e < topology.edge_count(); ++e)
    EXPECT_EQ(topology.sides(e).size(), e == 3 ? 1u : 2u);
  EXPECT_EQ(topology.find(3, 3), 3);
  EXPECT_EQ(topology.find(0, 3), -1);
}

}  // namespace
}  // namespace loosefit::geometry
