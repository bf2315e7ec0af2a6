#pragma once
#include <vector>

#include "loosefit/body/body.h"

namespace loosefit::dress {

/// The body seen from the front: for each cell of a grid in the (x, z) plane how far it reaches to
/// the front (least y) and to the back (largest y). The head is left out.
class BodyOutline {
 public:
  /// clearance: how far beyond the body `front` and `back` lie, sideways and in depth [m].
  BodyOutline(const body::Body& body, double clearance);

  /// Depth [m] of a sheet that passes before (behind) everything within the clearance of (x, z).
  double front(double x, double z) const { return sample(front_, x, z); }
  double back(double x, double z) const { return sample(back_, x, z); }
  /// A smooth surface between the two, continued beyond the silhouette.
  double middle(double x, double z) const { return sample(middle_, x, z); }
  /// Largest |x| of trunk, thighs and neck at height z on one side (+1 left, −1 right) [m].
  double trunk_half_width(double z, int side) const;

 private:
  double sample(const std::vector<double>& field, double x, double z) const;
  int index(int i, int j) const { return j * columns_ + i; }
  double x0_, z0_, cell_;
  int columns_, rows_;
  std::vector<double> front_, back_, middle_;
  std::vector<double> half_width_left_, half_width_right_;
};

}  // namespace loosefit::dress
