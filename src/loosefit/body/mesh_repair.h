#pragma once
#include <string>
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::body {

/// Drops vertices of no triangle and keeps the order of the others. Returns how many it dropped.
int drop_unused_vertices(geometry::TriangleMesh& mesh);

/// Drops triangles that have the three corners of an earlier one, whichever way they look. Returns
/// how many.
int drop_repeated_triangles(geometry::TriangleMesh& mesh);

/// Closes seams at which a surface is cut, as where a texture has its borders: unites open edges
/// whose ends lie within `distance` of each other, two at a time. Vertices away from open edges
/// stay as they are, so lips that only touch stay two; a closed surface is left alone. Nothing is
/// united that would give an edge more than two triangles. Drops what vanishes by it.
void weld_seams(geometry::TriangleMesh& mesh, double distance);

/// A ring of open edges, in order; the hole is on its left seen from outside.
struct Hole {
  std::vector<int> rim;
  Vec3 centre = Vec3::Zero();  ///< of the rim
  double width = 0;            ///< greatest distance of two vertices of the rim
};

/// All holes of a consistently oriented surface, the widest first.
std::vector<Hole> find_holes(const geometry::TriangleMesh& mesh);

/// Spans the rim with the triangles of least area between its own vertices (Barequet and Sharir
/// 1995) or, where the surface has such an edge already or the rim is long, with a fan.
void fill_hole(geometry::TriangleMesh& mesh, const Hole& hole);

}  // namespace loosefit::body
