#pragma once
#include <filesystem>

#include "loosefit/pattern/pattern.h"

namespace loosefit::report {

/// Adds pattern.json (GarmentCode) and pattern.svg (1:1) to `folder`, or makes it: both or none.
/// \throws InvalidInput if it is the output of a run or something foreign is in the way; IoError.
void write_pattern(const std::filesystem::path& folder, const pattern::Pattern& pattern);

}  // namespace loosefit::report
