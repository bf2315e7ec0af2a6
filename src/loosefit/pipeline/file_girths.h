#pragma once
#include <vector>

#include "loosefit/kinds/fit_stations.h"
#include "loosefit/kinds/kind.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::pipeline {

/// Girths of a garment that is known from a pattern file alone.
struct FileGirths {
  std::vector<kinds::FitLevel> levels;
  std::vector<kinds::FitStation> stations;  ///< along trunk and arm
};

/// Widths of the flat outlines at the levels of a body, summed over the panels that lie there, as
/// drape/arrange_panels.h brings them to the body: a garment with armholes by its highest point to
/// the high point shoulder, trousers by their crotch, a skirt by its upper edge to the waist.
/// Chest: below the armholes, where the bust lies lower there, unless the garment ends above; waist
/// and hip by length of a tape down the back; thigh and knee where trousers are drafted to them;
/// upper arm 2 cm below the armhole; ends of sleeves and legs, waist of trousers and skirts: the
/// length of the open edge. Ends of sleeves are compared with the wrist where the sleeve is as long
/// as the arm within 15 %. Bands, hoods, collars and pockets are no part of a level. \param
/// measured of the body, as Body::measured; what it lacks leaves out levels and bodies
FileGirths file_girths(const pattern::Pattern& pattern, const kinds::NamedValues& measured);

}  // namespace loosefit::pipeline
