#pragma once
#include <vector>

#include "loosefit/maps/worn_garment.h"

namespace loosefit::placement {

/// How the long axes of the body's segments run in the pattern of a worn garment: for sensors that
/// lie along a limb or the trunk, or around it, whatever way the panel is cut. One angle per
/// garment triangle, from the warp, counter-clockwise [rad] (FootprintShape), towards the trunk and
/// upwards.
class SegmentDirection {
 public:
  SegmentDirection(const garment::Garment& garment, const std::vector<Vec3>& positions,
                   const body::PosedBody& body, const maps::WornGarment& worn);
  /// Along the segment at a triangle; 0, the grain, where the body under it has no long axis in the
  /// plane of the cloth (on top of the shoulders, on a scan without joints).
  double along(int triangle) const { return angles_[triangle]; }
  /// Around it: a quarter turn further.
  double around(int triangle) const { return angles_[triangle] + kPi / 2; }

 private:
  std::vector<double> angles_;
};

}  // namespace loosefit::placement
