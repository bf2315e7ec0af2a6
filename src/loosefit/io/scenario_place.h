#pragma once
#include "loosefit/base/error.h"
#include "loosefit/scenario/scenario.h"

namespace loosefit::io {

/// An error that a later stage raised about a value of the scenario ("fit.sleeve", "attachment
/// x.at", "chest"), told with the scenario's file, line and key. An error that names a file stays
/// as it is.
InvalidInput in_scenario(const InvalidInput& error, const scenario::Scenario& scenario);

}  // namespace loosefit::io
