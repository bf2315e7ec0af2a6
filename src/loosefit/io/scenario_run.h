#pragma once
#include "loosefit/io/config_reader.h"
#include "loosefit/scenario/scenario.h"

namespace loosefit {

/// [material], also of an [[under]].
MaterialCard read_material_section(ConfigReader table);
/// [simulation]
ScenarioSimulation read_simulation_section(ConfigReader table);
/// [output]
ScenarioOutput read_output_section(ConfigReader table);
/// [ranking]
ScenarioRanking read_ranking_section(ConfigReader table);

}  // namespace loosefit
