#pragma once

// All of the library that other programs are meant to use (docs/library.md). These headers need
// nothing but the standard library.
#include "loosefit/base/error.h"     // IWYU pragma: export
#include "loosefit/base/paths.h"     // IWYU pragma: export
#include "loosefit/base/progress.h"  // IWYU pragma: export
#include "loosefit/base/version.h"   // IWYU pragma: export
#include "loosefit/library/run.h"    // IWYU pragma: export
