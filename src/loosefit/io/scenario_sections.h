#pragma once
#include "loosefit/io/config_reader.h"
#include "loosefit/io/scenario.h"

// One reader per section of a scenario; scenario.cpp calls them in order. Each reads all keys of
// its table, fills in defaults and refuses the keys it does not know.
namespace loosefit {

/// [postures]: the list with the reference posture first; `body` is [body].
std::vector<std::string> read_postures_section(ConfigReader table, ConfigReader body);
/// `postures`: those of [postures]; the first is the default of body.posture.
ScenarioBody read_body_section(ConfigReader table, const std::vector<std::string>& postures);
GarmentSpec read_garment_section(ConfigReader table);
/// The keys of [garment]; does not refuse others.
GarmentSpec read_garment_keys(ConfigReader& table);
MaterialCard read_material_section(ConfigReader table);
ScenarioGarment read_under_section(ConfigReader table);
Attachment read_attachment_section(ConfigReader table);
SiteSpec read_site_section(ConfigReader table);
ScenarioSimulation read_simulation_section(ConfigReader table);
ScenarioOutput read_output_section(ConfigReader table);
ScenarioRanking read_ranking_section(ConfigReader table);
/// [donning]; `given`: the section stands in the file. [simulation] must have been read.
ScenarioDonning read_donning_section(ConfigReader table, bool given,
                                     const ScenarioSimulation& simulation);

/// [garment] and [[under]] as TOML.
std::string garment_toml(const GarmentSpec& garment, const std::string& section = "garment");
std::string under_toml(const ScenarioGarment& under);

/// [postures] and [donning] as TOML; empty where there is nothing to say.
std::string wear_toml(const Scenario& scenario);

/// One [[site]] as TOML, every default written out.
std::string site_toml(const SiteSpec& site);

/// Shortest degrees that read back to the same radians.
std::string degrees_text(double angle);

/// Absolute form of a file named in the scenario, relative to the scenario's folder.
/// \throws InvalidInput if it does not exist or is not a file.
std::string existing_file(ConfigReader& table, const std::string& key);

}  // namespace loosefit
