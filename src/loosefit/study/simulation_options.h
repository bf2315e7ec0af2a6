#pragma once
#include "loosefit/drape/drape_options.h"
#include "loosefit/scenario/scenario.h"

namespace loosefit {

/// What the drape stage needs of [simulation]; `repeat` shifts the seed.
/// \throws InvalidInput for an unknown integrator.
DrapeOptions drape_options(const ScenarioSimulation& simulation, int repeat = 0);

}  // namespace loosefit
