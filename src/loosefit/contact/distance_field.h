#pragma once
#include <atomic>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "loosefit/contact/contact_surface.h"
#include "loosefit/contact/contact_tuning.h"
#include "loosefit/geometry/box_pairs.h"
#include "loosefit/geometry/closest_point_tree.h"

namespace loosefit::contact {

inline constexpr double kFieldSpacing = kContact.field.spacing;  ///< in every drape [m]

/// Smooth signed distance to a body surface for contact: exact point-to-surface distance sampled on
/// a grid in a narrow band, interpolated by tricubic Catmull-Rom splines (C¹, reproduces the node
/// values, error O(spacing³)), so that closest-point kinks of the triangulation do not stall
/// Newton. Not used for the distance map, which asks the surface itself.
///
/// A node is measured when it is first asked for: cloth comes near to a small part of the band. Any
/// number of threads may sample at once; whoever measures a node finds the same bits.
class DistanceField : public ContactSurface {
 public:
  /// region: where distances are wanted; spacing of the grid [m]; covers: further closed surfaces
  /// that hide the body in them (hulls of hands), the field is that of all together.
  /// Keeps a reference to the tree. \pre surfaces are closed and oriented outwards
  DistanceField(const geometry::ClosestPointTree& tree, const geometry::Box3& region,
                double spacing = kFieldSpacing,
                const std::vector<geometry::TriangleMesh>& covers = {});

  /// Bound of the interpolant's slope: where the skin's distance has creases in every cell it
  /// overshoots. Along one axis slopes −1, 1, −1 of the nodes give 1.5 in the middle; the weights
  /// across the other two add up to 1.25 each.
  static constexpr double kSteepest = 1.5 * 1.25 * 1.25;

  /// Whether places in the box can be interpolated, as far as the grid goes.
  bool covers(const geometry::Box3& box) const;
  double spacing() const { return spacing_; }  ///< [m]
  /// Whether the region needed more nodes than FieldTuning::max_nodes, so that the grid is coarser
  /// than was asked for: contact is then less exact, and callers should tell.
  bool is_coarsened() const { return spacing_ > requested_spacing_; }
  /// Distance up to which every place on the grid is interpolated [m].
  double smooth_reach() const;

  /// As ContactSurface::sample. Derivatives are those of the interpolant.
  bool sample(const Vec3& p, double reach, bool with_hessian, Sample& out) const override;
  /// Signed distance to the surfaces themselves [m], which the nodes hold. A bound on the distance
  /// to the body that is known to hold makes it faster.
  double exact_distance(const Vec3& p, double bound) const;

 private:
  enum class Zone : std::uint8_t { band, outside, inside };
  /// A closed surface that hides the body in it.
  struct Cover {
    explicit Cover(const geometry::TriangleMesh& surface);
    geometry::TriangleMesh mesh;
    geometry::Box3 box;
    geometry::ClosestPointTree tree;
  };
  /// Makes the nodes within the band of the triangles part of it.
  void mark_near(const geometry::TriangleMesh& mesh);
  /// Tells what is outside from what is inside, off the band.
  void flood_outside();
  int index(int x, int y, int z) const { return (z * size_[1] + y) * size_[0] + x; }
  Vec3 place(int x, int y, int z) const { return origin_ + spacing_ * Vec3(x, y, z); }
  /// Value of a node, NaN off the band.
  float value(int x, int y, int z) const;
  float measure(int x, int y, int z) const;
  /// Measures the nodes that a place in the cell is interpolated from; false when some are off the
  /// band.
  bool measure_round(const std::array<int, 3>& cell) const;
  /// At q [cells]; false when a node has not been measured or is off the band.
  bool interpolate(const std::array<int, 3>& cell, const Vec3& q, bool with_hessian,
                   Sample& out) const;
  const geometry::ClosestPointTree& tree_;
  std::deque<Cover> covers_;
  Vec3 origin_;
  double requested_spacing_, spacing_;
  std::array<int, 3> size_;
  mutable std::vector<std::atomic<float>> value_;  ///< NaN off the band, and where not yet measured
  std::vector<Zone> zone_;
};

}  // namespace loosefit::contact
