#pragma once
#include <array>
#include <vector>

#include "loosefit/garment/garment.h"

namespace loosefit::placement {

/// A triangle of the garment laid into the plane of another piece.
struct FlatTriangle {
  int triangle = 0;
  std::array<Vec2, 3> corners;  ///< [m]
};

/// For every triangle and each of its edges (corner k → k + 1): the triangle beyond, −1 at a free
/// edge.
using TriangleNeighbours = std::vector<std::array<int, 3>>;
TriangleNeighbours triangle_neighbours(const garment::Garment& garment);

/// How the triangle beyond an edge lies against this one.
struct AcrossEdge {
  std::array<int, 2> ends = {};  ///< its corners at the start and the end of the edge
  bool seam = false;             ///< the pattern does not go on there
  /// Directions in its pattern into those of this triangle's, once it is laid flat on the other
  /// side of the edge; a reflection behind a right-to-wrong seam.
  Mat2 turn = Mat2::Identity();
};
/// For the edge from corner k to k + 1 of `triangle`. \pre `next` lies beyond it
AcrossEdge across_edge(const garment::Garment& garment, int triangle, int k, int next);

/// All triangles that come within `reach` [m] of `centre`, a place in pattern coordinates of
/// `triangle`. Pieces of the same panel stay where the pattern has them; across a seam the
/// neighbour is turned and moved rigidly so that the two sides of the seam's mesh edge fit at their
/// middles. Each triangle comes once, by the way that brings it nearest. In order of distance.
/// `neighbours` are those of the garment; found anew when not given, which costs more than the
/// rest.
std::vector<FlatTriangle> unfold(const garment::Garment& garment, int triangle, const Vec2& centre,
                                 double reach, const TriangleNeighbours* neighbours = nullptr);

/// Barycentric weights of `p` in a triangle of the plane; all 0 … 1 inside. NaN without area.
Vec3 weights_in(const std::array<Vec2, 3>& corners, const Vec2& p);

}  // namespace loosefit::placement
