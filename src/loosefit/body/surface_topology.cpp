#include "loosefit/body/surface_topology.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "loosefit/base/union_find.h"
#include "loosefit/body/mesh_repair.h"
#include "loosefit/geometry/mesh_topology.h"

namespace loosefit::body {
std::vector<Piece> connected_pieces(const geometry::TriangleMesh& mesh) {
  UnionFind sets(mesh.triangles.size());
  const geometry::MeshTopology topology(mesh.triangles);
  for (int e = 0; e < topology.edge_count(); ++e)
    for (const auto& side : topology.sides(e))
      sets.unite(topology.sides(e)[0].triangle, side.triangle);
  std::map<int, Piece> pieces;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    Piece& piece = pieces[sets.find(int(i))];
    piece.triangles.push_back(int(i));
    piece.area +=
        geometry::triangle_area(mesh.vertices[std::size_t(t[0])], mesh.vertices[std::size_t(t[1])],
                                mesh.vertices[std::size_t(t[2])]);
  }
  std::vector<Piece> sorted;
  for (auto& [root, piece] : pieces) sorted.push_back(std::move(piece));
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Piece& a, const Piece& b) { return a.area > b.area; });
  return sorted;
}

void keep_piece(geometry::TriangleMesh& mesh, const Piece& piece) {
  std::vector<Triangle> kept;
  for (const int t : piece.triangles) kept.push_back(mesh.triangles[std::size_t(t)]);
  mesh.triangles = std::move(kept);
  drop_unused_vertices(mesh);
}

EdgeReport inspect_edges(const geometry::TriangleMesh& mesh) {
  EdgeReport report;
  const geometry::MeshTopology topology(mesh.triangles);
  std::vector<geometry::MeshTopology::Edge> open;
  for (int e = 0; e < topology.edge_count(); ++e) {
    const auto& edge = topology.edges()[std::size_t(e)];
    if (topology.sides(e).size() == 1) open.push_back(edge);
    if (topology.sides(e).size() > 2) {
      ++report.crowded;
      report.place = mesh.vertices[std::size_t(edge[0])];
    }
  }
  report.open = int(open.size());
  UnionFind sets(mesh.vertices.size());
  for (const auto& [low, high] : open) sets.unite(low, high);
  std::map<int, int> size;
  for (const auto& [low, high] : open) ++size[sets.find(low)];
  report.holes = int(size.size());
  int largest = 0;
  for (const auto& [root, count] : size) {
    if (count > largest) largest = count, report.place = mesh.vertices[std::size_t(root)];
  }
  return report;
}

Orientation orient_consistently(geometry::TriangleMesh& mesh) {
  // Neighbours over each edge; two triangles agree when they run along it in opposite senses.
  const geometry::MeshTopology topology(mesh.triangles);
  struct Link {
    int other;
    bool agrees;
  };
  std::vector<std::vector<Link>> links(mesh.triangles.size());
  // From the lower vertex of its edge to the higher one.
  const auto runs_up = [&](const geometry::MeshTopology::Side& side) {
    const Triangle& t = mesh.triangles[std::size_t(side.triangle)];
    return t[std::size_t(side.corner)] < t[std::size_t(side.corner + 1) % 3];
  };
  for (int e = 0; e < topology.edge_count(); ++e) {
    const auto sides = topology.sides(e);
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
      const bool agrees = runs_up(sides[i]) != runs_up(sides[i + 1]);
      links[std::size_t(sides[i].triangle)].push_back({sides[i + 1].triangle, agrees});
      links[std::size_t(sides[i + 1].triangle)].push_back({sides[i].triangle, agrees});
    }
  }
  // From one triangle of each piece on, decide for the neighbours whether to turn them; a
  // contradiction is a one-sided surface.
  std::vector<int> turn(mesh.triangles.size(), -1);
  bool any = false;
  for (std::size_t first = 0; first < turn.size(); ++first) {
    if (turn[first] >= 0) continue;
    turn[first] = 0;
    std::vector<int> stack = {int(first)};
    while (!stack.empty()) {
      const auto t = std::size_t(stack.back());
      stack.pop_back();
      for (const auto& link : links[t]) {
        const int expected = link.agrees ? turn[t] : 1 - turn[t];
        int& other = turn[std::size_t(link.other)];
        if (other < 0) {
          other = expected;
          stack.push_back(link.other);
        } else if (other != expected) {
          return Orientation::impossible;
        }
      }
    }
  }
  // Turn those that were marked.
  for (std::size_t t = 0; t < turn.size(); ++t) {
    if (turn[t] == 1) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]), any = true;
  }
  return any ? Orientation::repaired : Orientation::consistent;
}

}  // namespace loosefit::body
