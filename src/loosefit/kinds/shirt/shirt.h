#pragma once
#include "loosefit/kinds/kind.h"

namespace loosefit::kinds {

/// A knit shirt of six pieces with sleeves down to the wrist (shirt_draft.h).
GarmentKind long_sleeve_shirt();
/// The same draft with sleeves that end above the elbow.
GarmentKind t_shirt();

}  // namespace loosefit::kinds
