#pragma once
#include <vector>

#include "loosefit/drape/polyline.h"
#include "loosefit/garment/open_seams.h"

namespace loosefit::drape {

/// A sleeve in one piece, which is sewn to itself along the arm: rolled to a tube, its own seam
/// below, as wide as it is cut, wider where the arm needs it. Only the start of sewing, where rest
/// lengths do not matter.
class RolledSleeve {
 public:
  /// \param placed vertices of open.garment [m] \param from a point at the end of the sleeve
  /// \param axis unit vector along the sleeve, outwards \param normal of the panel's outside
  RolledSleeve(const garment::OpenSeams& open, const std::vector<Vec3>& placed, int panel,
               const Vec3& from, const Vec3& axis, const Vec3& normal);
  /// False for a panel that goes round only a part of the arm.
  bool goes_round() const { return girths_.size() > 1; }
  /// Writes its vertices to x: `offset` is where its end lies along the arm, `wider` what is added
  /// to the radius [m].
  void place(const Polyline& arm, double offset, double wider, std::vector<Vec3>& x) const;

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
