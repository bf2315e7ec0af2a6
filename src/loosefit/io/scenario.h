#pragma once
#include <string>

#include "loosefit/scenario/scenario.h"

namespace loosefit::io {

/// The default scenario: the reference shirt on the default woman.
scenario::Scenario default_scenario();

/// \throws IoError if the file cannot be read; InvalidInput for anything wrong in it. Files named
/// in it are taken relative to its folder and must exist.
scenario::Scenario read_scenario(const std::string& path);

/// As read_scenario; `file` is for messages and for resolving relative paths.
scenario::Scenario parse_scenario(const std::string& text, const std::string& file);

}  // namespace loosefit::io
