#pragma once
#include "loosefit/kinds/kind.h"

namespace loosefit::kinds {

/// A garment that is only known from a pattern file: its panels are sewn round the
/// body from where it places them, and what goes through its openings is told by how they lie to
/// each other. Its girths tell the openings of the sewn garment (pipeline/file_girths.h); the
/// measures are those of the body that they are compared with.
GarmentKind pattern_file();

}  // namespace loosefit::kinds
