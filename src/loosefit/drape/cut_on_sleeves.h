#pragma once
#include <optional>

#include "loosefit/body/posed_body.h"
#include "loosefit/garment/garment.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::drape {

/// Angle between sleeves that are cut in one piece with front and back (kimono, dolman) and the
/// downward vertical, where the pattern places them, the mean of both [rad]: held so, arms lie
/// between the pieces. Sleeves are known by openings for arms that begin 10 cm beyond the wearer's
/// shoulder tips, in the pieces that end at the hem. Nothing for other garments and for bodies
/// without landmarks.
std::optional<double> cut_on_sleeve_angle(const garment::Garment& garment,
                                          const pattern::Pattern& pattern,
                                          const body::PosedBody& body);

}  // namespace loosefit::drape
