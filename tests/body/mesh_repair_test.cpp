#include "loosefit/body/mesh_repair.h"

#include <gtest/gtest.h>

#include "loosefit/body/surface_topology.h"

namespace loosefit::body {
namespace {

/// A closed box from `lower` to `upper`, outwards.
geometry::TriangleMesh box(const Vec3& lower, const Vec3& upper) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.emplace_back(i & 1 ? upper.x() : lower.x(), i & 2 ? upper.y() : lower.y(),
                               i & 4 ? upper.z() : lower.z());
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

geometry::TriangleMesh cut_at_every_edge(const geometry::TriangleMesh& mesh) {
  geometry::TriangleMesh cut;
  for (const Triangle& t : mesh.triangles) {
    const int first = int(cut.vertices.size());
    for (const int v : t) cut.vertices.push_back(mesh.vertices[std::size_t(v)]);
    cut.triangles.push_back({first, first + 1, first + 2});
  }
  return cut;
}

/// A mouth: upper and lower lip are two blocks on one jaw whose inner edges lie on each other.
geometry::TriangleMesh lips_that_touch() {
  geometry::TriangleMesh upper = box({0, 0, 1}, {1, 1, 2});
  const geometry::TriangleMesh lower = box({0, -1, 0}, {1, 0, 1});  // shares the edge y = 0, z = 1
  const int base = int(upper.vertices.size());
  upper.vertices.insert(upper.vertices.end(), lower.vertices.begin(), lower.vertices.end());
  for (const auto& t : lower.triangles)
    upper.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  return upper;
}

TEST(MeshRepair, LipsThatTouchAreNotWelded) {
  geometry::TriangleMesh mesh = lips_that_touch();
  const auto vertices = mesh.vertices;
  weld_seams(mesh, 1e-6);
  EXPECT_EQ(mesh.vertices, vertices);
  EXPECT_EQ(inspect_edges(mesh).crowded, 0);
  EXPECT_EQ(inspect_edges(mesh).open, 0);
}

TEST(MeshRepair, SeamsAreWeldedButNoEdgeIsCrowded) {
  geometry::TriangleMesh seams = cut_at_every_edge(box({0, 0, 0}, {1, 1, 1}));
  for (std::size_t v = 0; v < seams.vertices.size(); ++v)
    seams.vertices[v].x() += v % 2 ? 4e-7 : 0;  // corners of one place in neighbouring cells
  weld_seams(seams, 1e-6);
  EXPECT_EQ(seams.vertices.size(), 8u);
  EXPECT_EQ(inspect_edges(seams).open, 0);

  // Where four open edges lie on each other, at most two are united.
  geometry::TriangleMesh lips = cut_at_every_edge(lips_that_touch());
  weld_seams(lips, 1e-6);
  EXPECT_EQ(inspect_edges(lips).crowded, 0);
  EXPECT_LT(lips.vertices.size(), 72u);
}

TEST(MeshRepair, RepeatedFacesAndLooseVerticesGo) {
  geometry::TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
  mesh.vertices.emplace_back(50, 0, 0);
  mesh.triangles.push_back({1, 2, 0});
  mesh.triangles.push_back({4, 6, 5});
  EXPECT_EQ(drop_repeated_triangles(mesh), 2);
  EXPECT_EQ(drop_unused_vertices(mesh), 1);
  EXPECT_EQ(mesh.triangles, box({0, 0, 0}, {1, 1, 1}).triangles);
}

TEST(MeshRepair, AFilledHoleClosesTheSurfaceAsItWas) {
  const geometry::TriangleMesh whole = box({0, 0, 0}, {1, 1, 1});
  for (std::size_t missing = 0; missing < 12; ++missing) {
    for (const std::size_t count : {1u, 2u, 4u}) {  // a face, a side, two sides
      if (missing % count != 0) continue;
      geometry::TriangleMesh mesh = whole;
      mesh.triangles.erase(mesh.triangles.begin() + long(missing),
                           mesh.triangles.begin() + long(missing + count));
      std::vector<Hole> holes = find_holes(mesh);
      for (; !holes.empty(); holes = find_holes(mesh)) fill_hole(mesh, holes.front());
      const EdgeReport edges = inspect_edges(mesh);
      EXPECT_EQ(edges.open + edges.crowded, 0) << missing << ' ' << count;
      EXPECT_EQ(orient_consistently(mesh), Orientation::consistent);
      if (count < 4) {
        EXPECT_NEAR(geometry::enclosed_volume(mesh), 1, 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace loosefit::body
