#pragma once
#include <string>

#include "loosefit/base/error.h"
#include "loosefit/scenario/scenario.h"

// Reading and writing of a scenario as TOML.
namespace loosefit {

/// The default scenario: the reference shirt on the default woman.
Scenario default_scenario();

/// \throws IoError if the file cannot be read; InvalidInput for anything wrong in it. Files named
/// in it are taken relative to its folder and must exist.
Scenario read_scenario(const std::string& path);

/// An error that a later stage raised about a value of the scenario ("fit.sleeve", "attachment
/// x.at", "chest"), told with the scenario's file, line and key. An error that names a file stays
/// as it is.
InvalidInput in_scenario(const InvalidInput& error, const Scenario& scenario);

/// As read_scenario; `file` is for messages and for resolving relative paths.
Scenario parse_scenario(const std::string& text, const std::string& file);

/// The resolved scenario as TOML, every default written out; parsing it gives the same scenario.
std::string scenario_toml(const Scenario& scenario);

}  // namespace loosefit
