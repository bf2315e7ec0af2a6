#pragma once
#include <filesystem>

#include "loosefit/io/dxf/dxf_read.h"
#include "loosefit/io/pattern_file.h"

namespace loosefit::io {

/// Reads a pattern file of any kind that is known, told by its content: GarmentCode JSON, DXF-AAMA
/// and ASTM D6673. \throws as read_garmentcode and read_dxf_pattern; InvalidInput for a size or
/// units that are asked of a file that has one size and says its units.
PatternFile read_pattern(const std::filesystem::path& path, const DxfWish& wish = {});

}  // namespace loosefit::io
