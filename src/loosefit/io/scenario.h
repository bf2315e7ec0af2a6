#pragma once
#include <string>

#include "loosefit/io/config_node.h"
#include "loosefit/scenario/scenario.h"

namespace loosefit::io {

class ConfigReader;

/// The default scenario: the reference shirt on the default woman.
scenario::Scenario default_scenario();

/// \throws IoError if the file cannot be read; InvalidInput for anything wrong in it. Files named
/// in it are taken relative to its folder and must exist.
scenario::Scenario read_scenario(const std::string& path);

/// As read_scenario; `file` is for messages and for resolving relative paths.
scenario::Scenario parse_scenario(const std::string& text, const std::string& file);

/// As parse_scenario, of a table that was parsed, or made by a program (then all lines are 0).
scenario::Scenario scenario_of(const ConfigNode& table, const std::string& file);

/// The reading itself, of the whole table; file and lines of the scenario stay empty.
scenario::Scenario read_scenario_root(ConfigReader& root);

}  // namespace loosefit::io
