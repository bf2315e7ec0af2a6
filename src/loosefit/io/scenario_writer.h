#pragma once
#include <string>

#include "loosefit/scenario/scenario.h"

namespace loosefit::io {

/// The resolved scenario as TOML, every default written out; parsing it gives the same scenario.
std::string scenario_toml(const scenario::Scenario& scenario);

}  // namespace loosefit::io
