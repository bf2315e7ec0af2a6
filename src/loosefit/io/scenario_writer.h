#pragma once
#include <string>

#include "loosefit/scenario/scenario.h"

namespace loosefit::io {

/// The resolved scenario as TOML, every default written out; parsing it gives the same scenario.
std::string scenario_toml(const scenario::Scenario& scenario);

/// Whether `digest` is the SHA-256 of such a text, as it is written now or as earlier versions
/// wrote it: with simulation.certificate.
bool is_digest_of(const std::string& digest, const std::string& toml);

}  // namespace loosefit::io
