#pragma once
#include "loosefit/kinds/shirt/shirt_blocks.h"

namespace loosefit::kinds {

/// What one bust dart takes up at the side seam [m]: the share of the bust balance that is asked
/// for; 0 where that is below the least dart that is sewn, 12 mm.
double bust_dart_intake(const ShirtMeasures& measures, const ShirtFit& fit);

/// Lengthens the front at its sides and takes that up in a dart that points at the bust point and
/// stops short of it (Aldrich 2008; docs/theory/patterns.md 6). Both side seams are cut where its
/// mouth is; legs are equal, so are the parts of the seams. Nothing changes, and the answer is
/// false, without an intake or where the side has no room for a dart.
bool take_bust_dart(TorsoHalf& front, TorsoHalf& back, const ShirtMeasures& measures,
                    const ShirtFit& fit);

}  // namespace loosefit::kinds
