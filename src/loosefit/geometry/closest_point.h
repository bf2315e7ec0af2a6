#pragma once
#include <functional>
#include <limits>
#include <vector>

#include "loosefit/geometry/triangle_mesh.h"

namespace loosefit {

/// Closest point on a triangle (Ericson 2005, Real-Time Collision Detection, 5.1.5).
/// Returns barycentric weights of (a, b, c); they sum to 1 and are ≥ 0.
Vec3 closest_barycentric(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// Answer of a closest-point query. `triangle` is -1 when nothing lies within the search radius.
struct ClosestPoint {
  int triangle = -1;
  Vec3 barycentric = Vec3::Zero();
  Vec3 point = Vec3::Zero();
  double distance = std::numeric_limits<double>::infinity();  ///< unsigned [m]
};

/// Axis-aligned bounding-box tree over a triangle mesh for exact point-to-surface queries.
/// Keeps a reference to the mesh: the mesh must outlive the tree and must not move.
class ClosestPointTree {
 public:
  /// Half of the work of making it is what tells inside from outside.
  enum class Sides { told, untold };
  explicit ClosestPointTree(const TriangleMesh& mesh, Sides sides = Sides::told);
  /// Nearest surface point within `max_distance`. Ties go to the lower triangle index.
  ClosestPoint query(const Vec3& p,
                     double max_distance = std::numeric_limits<double>::infinity()) const;
  /// The same among the triangles for which `accept(triangle)` holds.
  ClosestPoint query(const Vec3& p, double max_distance,
                     const std::function<bool(int)>& accept) const;
  /// Signed distance [m], negative inside; sign by angle-weighted pseudonormal
  /// (Bærentzen and Aanæs 2005). Needs a closed, outward oriented mesh. A bound on the distance
  /// that is known to hold makes it faster; +∞ beyond it. Throws std::logic_error with
  /// Sides::untold.
  double signed_distance(const Vec3& p, ClosestPoint* closest = nullptr,
                         double bound = std::numeric_limits<double>::infinity()) const;
  const TriangleMesh& mesh() const { return *mesh_; }

 private:
  struct Node {
    Vec3 lower, upper;
    int first = 0;  ///< leaf: first entry in order_; inner: left child
    int count = 0;  ///< leaf: number of triangles; inner: 0
  };
  /// Triangles [first, last) of order_, to go below `node`, with nodes from `free` on.
  struct Range {
    int node, free, first, last;
  };
  void find_pseudonormals();
  static std::size_t nodes_of(int n);
  void build(const Range& range, const std::vector<Vec3>& centroids);

  const TriangleMesh* mesh_;
  std::vector<Node> nodes_;
  std::vector<int> order_;
  std::vector<Vec3> vertex_pseudonormals_;
  std::vector<std::array<Vec3, 3>> edge_pseudonormals_;  ///< per triangle, edge i = corner i → i+1
};

/// Slow twin of ClosestPointTree::query, the oracle of its tests.
ClosestPoint closest_point_brute_force(const TriangleMesh& mesh, const Vec3& p);

}  // namespace loosefit
