#pragma once
#include "loosefit/pattern/pattern.h"

namespace loosefit::kinds {

/// A hood of two pieces that meet over the head and down its back.
struct HoodShape {
  double height = 0.35;  ///< of its front edge, from the neckline up [m]
  double depth = 0.25;   ///< from the front edge to the back of the head [m]
  double finish = 0;     ///< width of the hem along the front edge [m]
};

/// A strip of two layers round the hem.
struct HemBand {
  double width = 0.06;   ///< [m]; 0: none
  double stretch = 0;    ///< shorter than the hem by this share
  double stiffness = 2;  ///< in the plane, times that of the fabric
};

/// The least depth of a hood for the neckline of a drafted shirt [m]. \pre as add_hood
double least_hood_depth(const pattern::Pattern& shirt);

/// Sews a hood into the neckline of a drafted shirt, whose neck edges are parted in the middle for
/// it: pieces "hood_L" and "hood_R" with edges neck_front, neck_back, back and face. \pre `shirt`
/// has the pieces "front" and "back" of a shirt draft, and no neckband. \throws InvalidInput, key
/// "fit.hood_depth", where the hood is narrower than half of the neckline.
void add_hood(pattern::Pattern& shirt, const HoodShape& shape);

/// Sews a band to the hem: pieces "hem_band_front" and "hem_band_back" with edges seam, rim, end_L
/// and end_R.
void add_hem_band(pattern::Pattern& shirt, const HemBand& band);

}  // namespace loosefit::kinds
