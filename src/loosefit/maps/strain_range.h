#pragma once
#include <string>
#include <vector>

#include "loosefit/body/posed_body.h"
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

/// Of warp, weft and trellis shear. Beyond its range a law is extrapolated: a knit is stiffer there
/// by a factor.
struct StrainRange {
  DirectionRange warp, weft, shear;

  /// Share of the flat area beyond any of the stated limits [–].
  double share_beyond = 0;

  // Of the triangles as they are, without drawing fine waves straight.
  std::vector<int> crushed;    ///< a yarn direction is shorter than half its flat length
  std::vector<int> torn;       ///< a yarn direction is longer than the cloth bears
  double least = 0, most = 0;  ///< strains of yarn directions, of any triangle [–]
};

StrainRange strain_range(const garment::Garment& garment, const std::vector<Vec3>& positions,
                         const fabric::Material& material);

/// A torn region: a place of the wearer where cloth is strained so far that it would tear.
struct TornRegion {
  std::string name;               ///< of the region (body/regions.h)
  double share = 0;               ///< of the cloth there [–]
  bool is_warp = false;           ///< the direction that is farther beyond its limit
  double largest = 0, limit = 0;  ///< its largest strain there, and what it bears [–]
};

/// Regions of the body where more than half of the cloth, and more than 20 cm² of it, is strained
/// along warp or weft beyond what it bears (drape::borne_strain). In the order of the regions. A
/// body without segments is one region.
std::vector<TornRegion> torn_regions(const garment::Garment& garment,
                                     const std::vector<Vec3>& positions,
                                     const fabric::Material& material, const body::PosedBody& body);

}  // namespace loosefit::maps
