#pragma once
#include "loosefit/io/config_reader.h"
#include "loosefit/scenario/scenario.h"

namespace loosefit::io {

/// [material], also of an [[under]].
scenario::MaterialCard read_material_section(ConfigReader table);
/// [simulation]
scenario::ScenarioSimulation read_simulation_section(ConfigReader table);
/// [output]
scenario::ScenarioOutput read_output_section(ConfigReader table);
/// [ranking]
scenario::ScenarioRanking read_ranking_section(ConfigReader table);

}  // namespace loosefit::io
