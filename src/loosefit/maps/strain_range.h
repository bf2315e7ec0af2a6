#pragma once
#include <vector>

#include "loosefit/fabric/material.h"
#include "loosefit/garment/garment.h"

namespace loosefit::maps {

/// How the deformation of one direction compares with what its constants were measured over.
struct DirectionRange {
  double limit = 0;         ///< Material::valid_… [–] or [rad]; 0: the card states none
  double largest = 0;       ///< in the drape: elongation |F d| − 1 [–], or shear angle [rad]
  double share_beyond = 0;  ///< of the flat area that is beyond the limit [–]

  bool is_stated() const { return limit > 0; }
};

/// So many times the range over which a law was measured it is no law any more [–]; knits are some
/// ten times stiffer there already, wovens have torn. A choice.
inline constexpr double kFarBeyond = 3;

/// Of warp, weft and trellis shear. Beyond its range a law is extrapolated: a knit is stiffer there
/// by a factor, a woven breaks.
struct StrainRange {
  DirectionRange warp, weft, shear;

  /// Share of the flat area beyond any of the stated limits [–].
  double share_beyond = 0;
  /// Share of the flat area of which warp or weft is beyond kFarBeyond times its stated limit [–].
  double share_far_beyond = 0;
};

StrainRange strain_range(const garment::Garment& garment, const std::vector<Vec3>& positions,
                         const fabric::Material& material);

}  // namespace loosefit::maps
