#pragma once
#include <string>

#include "loosefit/io/config_reader.h"
#include "loosefit/scenario/scenario.h"

namespace loosefit::io {

/// One [[under]]: a garment, its cloth, its friction.
scenario::ScenarioGarment read_under_section(ConfigReader table);
/// The same as TOML.
std::string under_toml(const scenario::ScenarioGarment& under);

}  // namespace loosefit::io
