#pragma once
#include "loosefit/drape/drape_options.h"
#include "loosefit/scenario/scenario.h"

namespace loosefit::pipeline {

/// What the drape stage needs of [simulation]; `repeat` shifts the seed.
/// \throws InvalidInput for an unknown integrator.
drape::DrapeOptions drape_options(const scenario::ScenarioSimulation& simulation, int repeat = 0);

}  // namespace loosefit::pipeline
