#pragma once
#include "loosefit/kinds/kind.h"

namespace loosefit::kinds {

/// Four pieces and a waistband (trousers_draft.h), to be worn loose.
GarmentKind trousers();
/// The same pieces cut narrower than the wearer, for fabrics that stretch.
GarmentKind leggings();

}  // namespace loosefit::kinds
