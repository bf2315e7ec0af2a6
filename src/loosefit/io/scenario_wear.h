#pragma once
#include <string>
#include <vector>

#include "loosefit/io/config_reader.h"
#include "loosefit/scenario/scenario.h"

namespace loosefit::io {

/// The posture of a name that stands at `key` of a table. \throws InvalidInput there.
body::Posture posture_by_name(const std::string& name, const ConfigReader& table,
                              const std::string& key);
/// Regular expression of all such names, for the record.
std::string posture_pattern();
/// [postures]: list and sweep as one list with the reference posture first.
std::vector<std::string> read_postures_section(ConfigReader table);
/// [donning]; `given`: the section stands in the file. [simulation] must have been read.
scenario::ScenarioDonning read_donning_section(ConfigReader table, bool given,
                                               const scenario::ScenarioSimulation& simulation);
/// Both as TOML; empty where there is nothing to say.
std::string wear_toml(const scenario::Scenario& scenario);

}  // namespace loosefit::io
