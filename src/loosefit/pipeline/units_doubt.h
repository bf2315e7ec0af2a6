#pragma once
#include <string>
#include <vector>

#include "loosefit/kinds/kind.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::pipeline {

/// What is told of a pattern file that fits nobody in the units it says.
struct UnitsDoubt {
  std::string found;  ///< the measures of garment and body; empty: no doubt
  std::string hint;   ///< the factor that would make it a garment
  bool wears_nobody =
      false;  ///< nothing to drape: below 0.45 or above 5 times the body, or by its pieces
};

/// Judged by the girth at the first level that has one of the body: chest, waist of trousers, waist
/// of what names or labels say to be a skirt. More than 2.2 times the body's or less than half of
/// it is a doubt: loose coats on small adults and children's clothes on adults lie within. A waist
/// counts as long as elastics leave it. Other tubes are not judged: nobody knows for which limb
/// they are. Before that every pattern is judged by its pieces, in doubt and worn by nobody when
/// the largest is below 0.05 m (a cup or a cuff is longer), the largest one that is no strip above
/// 3 m, or any above 50 m. The factor is that of centimetres, millimetres, metres and inches taken
/// for each other which brings the girth nearest to 1.1 times the body's, or the piece to 0.7 m.
UnitsDoubt units_doubt(const pattern::Pattern& pattern, const std::vector<kinds::FitLevel>& levels);

}  // namespace loosefit::pipeline
