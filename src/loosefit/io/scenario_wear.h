#pragma once
#include <string>
#include <vector>

#include "loosefit/io/config_reader.h"
#include "loosefit/scenario/scenario.h"

namespace loosefit::io {

/// [postures]: the list with the reference posture first; `body` is [body].
std::vector<std::string> read_postures_section(ConfigReader table, ConfigReader body);
/// [donning]; `given`: the section stands in the file. [simulation] must have been read.
scenario::ScenarioDonning read_donning_section(ConfigReader table, bool given,
                                               const scenario::ScenarioSimulation& simulation);
/// Both as TOML; empty where there is nothing to say.
std::string wear_toml(const scenario::Scenario& scenario);

}  // namespace loosefit::io
