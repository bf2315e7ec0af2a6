#pragma once
#include <vector>

#include "loosefit/body/posed_body.h"
#include "loosefit/drape/polyline.h"
#include "loosefit/garment/open_seams.h"

namespace loosefit::drape {

/// A panel that is sewn to itself along a limb, such as a sleeve in one piece: rolled to a tube,
/// its own seam opposite to where its middle lies, as wide as it is cut, wider where the limb needs
/// it. Only the start of sewing, where rest lengths do not matter.
class RolledPanel {
 public:
  /// \param placed vertices of open.garment, of which those of the panel are read [m]
  /// \param from a point at the end of the tube \param axis unit vector along it
  /// \param normal of the panel's outside, which its middle faces
  RolledPanel(const garment::OpenSeams& open, const std::vector<Vec3>& placed, int panel,
              const Vec3& from, const Vec3& axis, const Vec3& normal);
  /// False for a panel that goes round only a part of the limb.
  bool goes_round() const { return girths_.size() > 1; }
  /// Writes its vertices to x: `offset` is where its end lies along the limb, `wider` what is added
  /// to the radius [m].
  void place(const Polyline& limb, double offset, double wider, std::vector<Vec3>& x) const;
  /// The same, wider in steps of 1 cm until it is clear of the body; after every five steps
  /// `farther` along the limb and as wide as it is cut again, if that is more than 0 [m].
  void place_clear(const Polyline& limb, double offset, double farther, const body::PosedBody& body,
                   std::vector<Vec3>& x) const;

 private:
  /// Where it is sewn to itself: at s along its axis, from `low` to `high` across it [m].
  struct Girth {
    double s, low, high;
  };
  struct Point {
    int vertex;
    double s, across;  ///< along the axis and across it [m]
  };
  Girth girth_at(double s) const;

  Vec3 axis_, normal_, across_;
  std::vector<Girth> girths_;  ///< by s
  std::vector<Point> points_;
};

}  // namespace loosefit::drape
