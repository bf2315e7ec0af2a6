#pragma once
#include <string>

#include "loosefit/io/config_reader.h"

namespace loosefit::io {

/// A path with that extension, as a pattern for existing_file.
inline constexpr const char* kTomlFile = "[^/]\\.toml$";

/// Absolute form of a file named in a configuration, relative to the folder of that; `about` and
/// `pattern` as of ConfigReader::path. \throws InvalidInput if it does not exist or is not a file.
std::string existing_file(ConfigReader& table, const std::string& key,
                          const std::string& about = {}, const std::string& pattern = {});

}  // namespace loosefit::io
