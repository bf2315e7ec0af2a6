#pragma once
#include "loosefit/io/config_reader.h"
#include "loosefit/io/scenario.h"

// One reader per section of a scenario; scenario.cpp calls them in order. Each reads all keys of
// its table, fills in defaults and refuses the keys it does not know.
namespace loosefit {

ScenarioBody read_body_section(ConfigReader table);
ScenarioGarment read_garment_section(ConfigReader table);
MaterialCard read_material_section(ConfigReader table);
Attachment read_attachment_section(ConfigReader table);
SiteSpec read_site_section(ConfigReader table);
ScenarioSimulation read_simulation_section(ConfigReader table);
ScenarioOutput read_output_section(ConfigReader table);
ScenarioRanking read_ranking_section(ConfigReader table);

/// One [[site]] as TOML, every default written out.
std::string site_toml(const SiteSpec& site);

/// Shortest degrees that read back to the same radians.
std::string degrees_text(double angle);

/// Absolute form of a file named in the scenario, relative to the scenario's folder.
/// \throws InvalidInput if it does not exist or is not a file.
std::string existing_file(ConfigReader& table, const std::string& key);

}  // namespace loosefit
