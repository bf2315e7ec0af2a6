#pragma once
#include <vector>

#include "loosefit/body/body.h"
#include "loosefit/garment/garment.h"
#include "loosefit/maps/worn_garment.h"

namespace loosefit::maps {

/// A horizontal cut through the draped torso of a garment.
struct GarmentGirth {
  double level = 0;   ///< height of the cut [m]
  double draped = 0;  ///< length of the cut on the draped cloth, folds followed [m]
  double flat = 0;    ///< length of the same cut in the flat pattern [m]
  /// Mean strain along the cut; −BGM/(1+BGM) for a tight garment. NaN without a cut.
  double hoop_strain() const;
};

/// Cuts the panels that belong to the trunk at height `level`. No cut of garments with panels that
/// cover trunk and arms in one: their sleeves would be cut with it.
GarmentGirth torso_girth(const garment::Garment& garment, const std::vector<Vec3>& positions,
                         const WornGarment& worn, double level);

/// Height of the wearer's chest in this posture: Body::measured chest_level, carried with the body
/// when it bends. \throws InvalidInput if the body has no chest level.
double chest_height(const body::Body& body);

}  // namespace loosefit::maps
