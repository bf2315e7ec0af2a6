#pragma once
#include "loosefit/kinds/shirt/shirt_blocks.h"

namespace loosefit::kinds {

/// Gives the back of a sleeve the length over a bent elbow (Armstrong 2010; docs/theory/patterns.md
/// 6): below the elbow the back half is turned about the top seam, and what that opens at the
/// underarm seam is sewn as a dart that ends in the middle of the half, at the elbow. The
/// underarm seams are cut there; their parts stay equal, so do the top seams.
/// \param level y of the elbow in the halves [m]; `girth`: of the sleeve there [m]
/// \param bend of the arm [degrees]
/// \return false, with nothing changed, without a bend or where the dart would take up less than
/// 5 mm.
bool take_elbow_dart(SleeveHalf& front, SleeveHalf& back, double level, double girth, double bend);

}  // namespace loosefit::kinds
