#pragma once
#include <array>
#include <vector>

#include "loosefit/geometry/flat_triangle.h"
#include "loosefit/geometry/mesh_topology.h"
#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit::geometry {

/// A place on a triangle surface.
struct SurfacePoint {
  int triangle = -1;
  Vec3 barycentric = Vec3::Zero();
};

/// What of a path lies in one triangle: a straight line between two places of it.
struct PathPiece {
  int triangle = -1;
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< barycentric
};

/// A path on a triangle surface; each piece begins where the one before ends.
using SurfacePath = std::vector<PathPiece>;

/// A triangle surface known by the lengths of its edges alone: of a mesh in space, or of flat
/// pieces that are sewn together and have no common plane. Paths on it are straight where the
/// triangles that they pass are laid flat one after the other.
class PathSurface {
 public:
  /// Lengths as in space [m].
  explicit PathSurface(const TriangleMesh& mesh);
  /// Lengths as in the flat [m]; where two triangles disagree about an edge, as at a seam that
  /// eases one side in, their mean.
  PathSurface(std::vector<Triangle> triangles, const std::vector<FlatCorners>& flat);

  const MeshTopology& topology() const { return topology_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  double edge_length(int edge) const { return length_[edge]; }
  /// Corners of a triangle laid flat, counter-clockwise: the first at the origin, the second on the
  /// x axis [m].
  const FlatCorners& flat(int triangle) const { return flat_[triangle]; }
  /// Length of a piece [m].
  double length(const PathPiece& piece) const;
  double length(const SurfacePath& path) const;

 private:
  void lay_flat();
  std::vector<Triangle> triangles_;
  MeshTopology topology_;
  std::vector<double> length_;     ///< per edge
  std::vector<FlatCorners> flat_;  ///< per triangle
};

}  // namespace loosefit::geometry
