#pragma once
#include <filesystem>
#include <string>

namespace loosefit::io {

/// Writes one file that appears whole or not at all. What stands there already stays as it is,
/// unless it may be replaced. \throws InvalidInput when something stands there and may not be
/// replaced, or is a folder, a device or a pipe; IoError when the folder is not there or the file
/// cannot be written in full.
void write_whole_file(const std::filesystem::path& file, const std::string& bytes,
                      bool may_replace);
/// The same refusal before the work. \throws InvalidInput, IoError
void check_whole_file(const std::filesystem::path& file, bool may_replace);

}  // namespace loosefit::io
