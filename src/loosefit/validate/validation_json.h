#pragma once
#include <string>

#include "loosefit/validate/run_validation.h"

namespace loosefit::validate {

/// validation.json; keys in docs/outputs.md. Numbers that are not finite are null.
std::string validation_json(const Validation& validation);

}  // namespace loosefit::validate
