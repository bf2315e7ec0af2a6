#pragma once
#include <cstddef>
#include <string>

namespace loosefit::io {

/// Whole content of a regular file. \throws IoError (missing, a folder, no permission) and
/// InvalidInput when it is larger than `max_bytes`.
std::string read_text_file(const std::string& path, std::size_t max_bytes);

/// The same as text of any editor (io/text_encoding.h): UTF-8 without a byte order mark.
std::string read_plain_text(const std::string& path, std::size_t max_bytes);

/// Writes and flushes to the disk's acceptance. \throws IoError naming the cause (disk full, …).
void write_text_file(const std::string& path, const std::string& text);

}  // namespace loosefit::io
