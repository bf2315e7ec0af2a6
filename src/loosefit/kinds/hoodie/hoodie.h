#pragma once
#include "loosefit/kinds/kind.h"

namespace loosefit::kinds {

/// The draft of a long-sleeve shirt, roomy, with a hood of two pieces in place of a neckband, cuffs
/// and a band round the hem (hood_draft.h).
GarmentKind hoodie();

}  // namespace loosefit::kinds
