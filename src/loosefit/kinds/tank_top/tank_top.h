#pragma once
#include "loosefit/kinds/kind.h"

namespace loosefit::kinds {

/// A sleeveless shirt of two pieces that hangs on straps (tank_top_draft.h).
GarmentKind tank_top();

}  // namespace loosefit::kinds
