#include "loosefit/body/surface_topology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "loosefit/base/union_find.h"
#include "loosefit/body/mesh_repair.h"

namespace loosefit {
namespace {

struct EdgeUse {
  int low, high;  ///< vertices
  int triangle;
  bool forward;  ///< the triangle runs low → high
  bool operator<(const EdgeUse& o) const {
    return std::tie(low, high, triangle) < std::tie(o.low, o.high, o.triangle);
  }
};

std::vector<EdgeUse> edge_uses(const TriangleMesh& mesh) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const int a = mesh.triangles[t][c], b = mesh.triangles[t][(c + 1) % 3];
      uses.push_back({std::min(a, b), std::max(a, b), int(t), a < b});
    }
  }
  std::sort(uses.begin(), uses.end());
  return uses;
}

bool same_edge(const EdgeUse& a, const EdgeUse& b) { return a.low == b.low && a.high == b.high; }

}  // namespace

std::vector<Piece> connected_pieces(const TriangleMesh& mesh) {
  UnionFind sets(mesh.triangles.size());
  const auto uses = edge_uses(mesh);
  for (std::size_t i = 1; i < uses.size(); ++i) {
    if (same_edge(uses[i - 1], uses[i])) sets.unite(uses[i - 1].triangle, uses[i].triangle);
  }
  std::map<int, Piece> pieces;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    Piece& piece = pieces[sets.find(int(i))];
    piece.triangles.push_back(int(i));
    piece.area += triangle_area(mesh.vertices[std::size_t(t[0])], mesh.vertices[std::size_t(t[1])],
                                mesh.vertices[std::size_t(t[2])]);
  }
  std::vector<Piece> sorted;
  for (auto& [root, piece] : pieces) sorted.push_back(std::move(piece));
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Piece& a, const Piece& b) { return a.area > b.area; });
  return sorted;
}

void keep_piece(TriangleMesh& mesh, const Piece& piece) {
  std::vector<Triangle> kept;
  for (const int t : piece.triangles) kept.push_back(mesh.triangles[std::size_t(t)]);
  mesh.triangles = std::move(kept);
  drop_unused_vertices(mesh);
}

EdgeReport inspect_edges(const TriangleMesh& mesh) {
  EdgeReport report;
  const auto uses = edge_uses(mesh);
  std::vector<EdgeUse> open;
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t end = i + 1;
    while (end < uses.size() && same_edge(uses[i], uses[end])) ++end;
    if (end - i == 1) open.push_back(uses[i]);
    if (end - i > 2) {
      ++report.crowded;
      report.place = mesh.vertices[std::size_t(uses[i].low)];
    }
    i = end;
  }
  report.open = int(open.size());
  UnionFind sets(mesh.vertices.size());
  for (const auto& e : open) sets.unite(e.low, e.high);
  std::map<int, int> size;
  for (const auto& e : open) ++size[sets.find(e.low)];
  report.holes = int(size.size());
  int largest = 0;
  for (const auto& [root, count] : size) {
    if (count > largest) largest = count, report.place = mesh.vertices[std::size_t(root)];
  }
  return report;
}

Orientation orient_consistently(TriangleMesh& mesh) {
  const auto uses = edge_uses(mesh);
  // Neighbours over each edge; two triangles agree when they run along it in opposite senses.
  struct Link {
    int other;
    bool agrees;
  };
  std::vector<std::vector<Link>> links(mesh.triangles.size());
  for (std::size_t i = 0; i + 1 < uses.size(); ++i) {
    if (!same_edge(uses[i], uses[i + 1])) continue;
    const bool agrees = uses[i].forward != uses[i + 1].forward;
    links[std::size_t(uses[i].triangle)].push_back({uses[i + 1].triangle, agrees});
    links[std::size_t(uses[i + 1].triangle)].push_back({uses[i].triangle, agrees});
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
        const int wanted = link.agrees ? turn[t] : 1 - turn[t];
        int& other = turn[std::size_t(link.other)];
        if (other < 0) {
          other = wanted;
          stack.push_back(link.other);
        } else if (other != wanted) {
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

}  // namespace loosefit
