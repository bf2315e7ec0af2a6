#pragma once
#include <map>
#include <string>

namespace loosefit::kinds {

/// Numbers by name: measures of a body, or the fit of a garment. SI units.
using NamedValues = std::map<std::string, double>;

}  // namespace loosefit::kinds
