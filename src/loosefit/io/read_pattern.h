#pragma once
#include <filesystem>

#include "loosefit/io/dxf/dxf_read.h"
#include "loosefit/io/pattern_file.h"

namespace loosefit::io {

/// Reads a pattern file of any kind that is known, told by its content: GarmentCode JSON, DXF-AAMA
/// and ASTM D6673. Files that cannot say what is sewn take their seams from a side file
/// (io/seams_file.h): `seams`, else NAME.seams.toml beside them where there is one.
/// \throws as read_garmentcode, read_dxf_pattern and read_seams; InvalidInput for a size, units or
/// seams that are asked of a file that has them itself.
PatternFile read_pattern(const std::filesystem::path& path, const DxfWish& wish = {},
                         const std::filesystem::path& seams = {});

}  // namespace loosefit::io
