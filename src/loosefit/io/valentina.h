#pragma once
#include <filesystem>

#include "loosefit/io/pattern_file.h"

namespace loosefit::io {

/// What kind_of_file says of .val, .vit and .vst.
inline constexpr const char* kValentinaKind = "a Valentina or Seamly2D file (XML)";

/// Lets Valentina export the pieces of a pattern (.val) as DXF-AAMA into a folder of its own,
/// without a window, and reads that. The measures are those that the pattern names, looked for
/// beside it. Formulas of .val are evaluated by nobody else. \throws InvalidInput when Valentina is
/// not installed (package `valentina`) or gives no pieces, with what it says; and as
/// read_dxf_pattern.
PatternFile read_valentina(const std::filesystem::path& path, const PatternWish& wish = {});

}  // namespace loosefit::io
