#pragma once
#include <array>
#include <span>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::geometry {

/// Edges of a triangle surface and what lies at them, made once from the corners of its triangles.
/// Any surface: an edge of one triangle is border, and more than two triangles may meet at an edge.
/// All orders depend on the numbers of vertices and triangles alone.
class MeshTopology {
 public:
  using Edge = std::array<int, 2>;  ///< vertices, the lower one first
  /// A triangle at an edge, which runs from `corner` to the next corner of it.
  struct Side {
    int triangle, corner;
  };

  explicit MeshTopology(std::vector<Triangle> triangles);

  /// Each edge once, ascending.
  const std::vector<Edge>& edges() const { return edges_; }
  int edge_count() const { return static_cast<int>(edges_.size()); }
  /// The edge from this corner of the triangle to the next one.
  int edge(int triangle, int corner) const { return edge_of_[triangle][corner]; }
  /// The edge between two vertices in either order; −1 where there is none.
  int find(int a, int b) const;
  /// The triangles at an edge, ascending.
  std::span<const Side> sides(int edge) const {
    return {sides_.data() + first_side_[edge], sides_.data() + first_side_[edge + 1]};
  }

  /// Vertices that share an edge with each vertex, ascending.
  std::vector<std::vector<int>> vertex_neighbours() const;
  /// Closed chains of the edges that belong to one triangle, in the direction of that triangle,
  /// each from its lowest vertex. Where borders meet in a vertex a chain goes on to the lowest next
  /// one. \pre neighbouring triangles run round alike
  std::vector<std::vector<int>> boundary_loops() const;

 private:
  std::vector<Triangle> triangles_;
  std::vector<Edge> edges_;
  std::vector<std::array<int, 3>> edge_of_;
  std::vector<Side> sides_;
  std::vector<int> first_side_;
  std::vector<int> first_edge_;  ///< by lower vertex
};

}  // namespace loosefit::geometry
