#pragma once
#include <string>
#include <vector>

#include "loosefit/io/scenario.h"

namespace loosefit {

/// What a command makes beside the drape.
struct PlannedWork {
  bool log = false, sites = true, pictures = true, report = true;
};

/// Names of the files that this work on a scenario may write, relative to its folder: asked before
/// the simulation, which may then leave some out (postures that do not settle, maps of a sealed
/// drape). \throws as load_scorecard.
std::vector<std::string> planned_files(const Scenario& scenario, const PlannedWork& work);

}  // namespace loosefit
