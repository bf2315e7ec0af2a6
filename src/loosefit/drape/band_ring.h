#pragma once
#include <optional>
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/drape/polyline.h"
#include "loosefit/garment/open_seams.h"

namespace loosefit::drape {

/// A band in one piece: a strip whose ends are sewn together and one side of which is sewn to
/// other panels, such as a neckband, a waistband or a cuff. However it is drawn, it is laid as a
/// ring round the limb, where its side meets the side of those panels.
class BandRing {
 public:
  /// Nothing for a panel that is no such band. \param open a garment with its seams open
  static std::optional<BandRing> find(const garment::OpenSeams& open, int panel);
  /// The panels to which it is sewn.
  const std::vector<int>& sewn_to() const { return sewn_to_; }
  /// At least 2.5 times as long as wide.
  bool is_narrow() const { return narrow_; }
  /// Writes its vertices to x, in which the panels that it is sewn to are arranged: next to them on
  /// the side that the seam tells, each vertex in the direction of its partner, as wide as it is
  /// cut, wider where it would touch the body.
  void place(const garment::OpenSeams& open, const Polyline& limb, const body::PosedBody& body,
             std::vector<Vec3>& x) const;

 private:
  /// A vertex on the side that is sewn, and those of other panels that it is sewn to.
  struct Seam {
    int vertex;
    std::vector<int> to;
  };
  BandRing() = default;
  /// Middle of the places in x to which it is sewn [m].
  Vec3 middle(const std::vector<Vec3>& x) const;
  int panel_ = 0;
  bool narrow_ = false;
  std::vector<int> vertices_, sewn_to_;
  std::vector<Seam> side_;
  Vec3 across_ = Vec3::Zero();  ///< unit vector in the plane of the panel from end to end
};

}  // namespace loosefit::drape
