#pragma once
#include <array>
#include <functional>
#include <vector>

#include "loosefit/base/lazy.h"
#include "loosefit/geometry/box.h"
#include "loosefit/geometry/closest_point.h"
#include "loosefit/geometry/pseudonormals.h"

namespace loosefit::geometry {

/// Tree of axis-aligned bounding boxes (BVH) over a triangle mesh for exact point-to-surface
/// queries, and for what overlaps a box. Keeps a reference to the mesh: the mesh must outlive the
/// tree and must not move.
class ClosestPointTree {
 public:
  explicit ClosestPointTree(const TriangleMesh& mesh);
  /// Nearest surface point within `max_distance`. Ties go to the lower triangle index.
  ClosestPoint query(const Vec3& p,
                     double max_distance = std::numeric_limits<double>::infinity()) const;
  /// The same among the triangles for which `accept(triangle)` holds. It is asked before the
  /// distance is measured, of more triangles than could be nearest: it has to be cheap.
  ClosestPoint query(const Vec3& p, double max_distance,
                     const std::function<bool(int)>& accept) const;
  /// Signed distance [m], negative inside; sign by angle-weighted pseudonormal
  /// (Bærentzen and Aanæs 2005). Needs a closed, outward oriented mesh. A bound on the distance
  /// that is known to hold makes it faster; +∞ beyond it. The pseudonormals, half of the work of
  /// making a tree, are made for the first that asks.
  double signed_distance(const Vec3& p, ClosestPoint* closest = nullptr,
                         double bound = std::numeric_limits<double>::infinity()) const;
  /// The triangles whose boxes overlap this one, rising. Closed boxes: touching counts as overlap.
  std::vector<int> overlapping(const Box3& box) const;
  const TriangleMesh& mesh() const { return *mesh_; }

 private:
  /// Up to eight boxes side by side for the processor's wide registers, and what is in them: a
  /// node, or a single triangle. In single precision, rounded outwards; what that costs in
  /// sharpness is allowed for in `query`.
  struct Node {
    using Lanes = Eigen::Array<float, 8, 1>;
    std::array<Lanes, 3> lower, upper;
    std::array<int, 8> content;  ///< index of a node, or ~ place of a triangle
    int parts = 0;
  };
  struct Leaf {
    Vec3 a, b, c;
    int triangle;
  };
  struct Centroid {
    Vec3 place;
    int triangle;
  };
  static int nodes_of(int triangles);
  Leaf leaf(int triangle) const;
  /// Orders [first, last) so that parts of `size` lie together in space.
  static void split(std::vector<Centroid>& centroids, int first, int last, int size);
  /// Makes the node `index` of [first, last) and those below it, which follow it; their box.
  Box3 build(int index, std::vector<Centroid>& centroids, int first, int last);

  const TriangleMesh* mesh_;
  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;  ///< as they follow each other in the tree
  double reach_ = 0;          ///< largest absolute coordinate [m]
  Lazy<Pseudonormals> sides_;
};

}  // namespace loosefit::geometry
