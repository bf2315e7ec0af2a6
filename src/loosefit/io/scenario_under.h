#pragma once
#include <string>

#include "loosefit/io/config_reader.h"
#include "loosefit/scenario/scenario.h"

namespace loosefit {

/// One [[under]]: a garment, its cloth, its friction.
ScenarioGarment read_under_section(ConfigReader table);
/// The same as TOML.
std::string under_toml(const ScenarioGarment& under);

}  // namespace loosefit
