#pragma once
#include <filesystem>
#include <vector>

#include "loosefit/io/dxf/dxf_write.h"
#include "loosefit/pattern/pattern.h"

namespace loosefit::report {

/// Adds pattern.json (GarmentCode), pattern.svg (1:1) and pattern.dxf (DXF-AAMA, with the marks on
/// a layer of their own) to `folder`, or makes it: all or none. \throws InvalidInput if it is the
/// output of a run or something foreign is in the way; IoError.
void write_pattern(const std::filesystem::path& folder, const pattern::Pattern& pattern,
                   const std::vector<pattern::Notch>& notches = {},
                   const std::vector<io::PatternMark>& marks = {});

}  // namespace loosefit::report
