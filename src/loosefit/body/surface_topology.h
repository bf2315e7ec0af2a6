#pragma once
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::body {

/// A connected part: its triangles and area [m²].
struct Piece {
  std::vector<int> triangles;
  double area = 0;
};

/// Connected parts (by shared edges: bodies that touch in a point are two), largest area first.
std::vector<Piece> connected_pieces(const geometry::TriangleMesh& mesh);

/// Keeps one part and its vertices.
void keep_piece(geometry::TriangleMesh& mesh, const Piece& piece);

/// Edges that keep a surface from being closed, and a place to look at.
struct EdgeReport {
  int open = 0;               ///< one face
  int crowded = 0;            ///< more than two faces
  int holes = 0;              ///< connected groups of open edges
  Vec3 place = Vec3::Zero();  ///< on the largest hole, or else on a crowded edge
};
EdgeReport inspect_edges(const geometry::TriangleMesh& mesh);

enum class Orientation { consistent, repaired, impossible };

/// Turns triangles so that neighbours agree with the first of their part.
Orientation orient_consistently(geometry::TriangleMesh& mesh);

}  // namespace loosefit::body
