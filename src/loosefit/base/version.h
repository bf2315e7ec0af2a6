#pragma once
#include <map>
#include <string>

namespace loosefit {

/// That of the CMake project: "0.2.0".
std::string version();

/// This program, its build (base/build_id.h), the compiler and the libraries it was built with:
/// name → version, as recorded in summary.json.
std::map<std::string, std::string> versions();

}  // namespace loosefit
