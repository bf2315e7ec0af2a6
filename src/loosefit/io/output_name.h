#pragma once
#include <filesystem>

namespace loosefit::io {

/// \throws InvalidInput for a name of something to write that is empty or blank: it would be the
/// folder at hand, which nobody meant.
void check_output_name(const std::filesystem::path& name);

}  // namespace loosefit::io
