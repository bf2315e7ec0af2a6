#pragma once
#include "loosefit/kinds/kind.h"

namespace loosefit::kinds {

/// A garment that is only known from a pattern file: its panels are sewn round the
/// body from where it places them, and what goes through its openings is told by how they lie to
/// each other.
GarmentKind pattern_file();

}  // namespace loosefit::kinds
