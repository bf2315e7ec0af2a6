#pragma once
#include "loosefit/kinds/kind.h"
#include "loosefit/kinds/shirt/shirt_values.h"

namespace loosefit::kinds {

/// A knit shirt of six pieces with sleeves down to the wrist (shirt_draft.h).
GarmentKind long_sleeve_shirt();
/// The same draft with sleeves that end above the elbow.
GarmentKind t_shirt();

/// Of the same draft with another usual fit.
GarmentKind shirt_kind(const std::string& name, const std::string& title, const ShirtFit& usual);

}  // namespace loosefit::kinds
