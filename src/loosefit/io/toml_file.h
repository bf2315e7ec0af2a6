#pragma once
#include <string>

#include "loosefit/io/config_node.h"

namespace loosefit::io {

/// Parses TOML 1.0, in UTF-16 as well (io/text_encoding.h). `file` only appears in messages.
/// \throws InvalidInput with file and line for anything that is not TOML, for input above 1 MB and
/// for nesting deeper than 32.
ConfigNode parse_toml(const std::string& text, const std::string& file);

/// Text of a TOML file. \throws IoError if it cannot be read; InvalidInput for an empty file, one
/// of another program (io/file_kind.h) and one above 1 MB.
std::string read_toml_text(const std::string& path);

/// Reads and parses a file. \throws IoError if it cannot be read; InvalidInput as parse_toml.
ConfigNode read_toml(const std::string& path);

}  // namespace loosefit::io
