#pragma once
#include <string>
#include <vector>

#include "loosefit/kinds/kind.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::pipeline {

/// What is told of a pattern file that fits nobody in the units it says.
struct UnitsDoubt {
  std::string found;          ///< the measures of garment and body; empty: no doubt
  std::string hint;           ///< the factor that would make it a garment
  bool wears_nobody = false;  ///< below 0.45 or above 5 times the body, nothing to drape
};

/// Judged by the girth at the first level that has one of the body, chest or waist: more than 2.2
/// times the body's or less than half of it, farther than loose coats and children's clothes on
/// adults are. Where the pattern is too small or too large to have such a level, by its largest
/// piece, which is 0.12 to 3 m long. The factor is that of centimetres, millimetres, metres and
/// inches taken for each other which brings the girth nearest to the body's.
UnitsDoubt units_doubt(const pattern::Pattern& pattern, const std::vector<kinds::FitLevel>& levels);

}  // namespace loosefit::pipeline
