#pragma once
#include <map>
#include <vector>

#include "loosefit/base/types.h"

namespace loosefit::drape {

/// The middle of a sleeve's breadth along its length: sleeves that taper to one side, or into a
/// narrower cuff, do not lie straight round the line that ends in the middle of that.
class SleeveMiddle {
 public:
  /// The vertices `of` at x [m]; `from`: the middle of the sleeve's end, `axis`: from the armhole
  /// to there, `sideways`: across it in the plane of its panels, unit vectors.
  SleeveMiddle(const std::vector<int>& of, const std::vector<Vec3>& x, const Vec3& from,
               const Vec3& axis, const Vec3& sideways);
  /// Off the axis, at s along it from the end [m]; in the cap, of which only the upper part is
  /// there, as at its foot.
  double at(double s) const;

 private:
  double of(int slice) const;
  std::map<int, double> middle_;  ///< by slice of the length [m]
  int foot_ = 0;                  ///< slice of the largest breadth
};

}  // namespace loosefit::drape
