#pragma once
#include <string>
#include <utility>
#include <vector>

namespace loosefit::validate {

/// The one configuration that all benchmarks share, for the reader: (what, how).
std::vector<std::pair<std::string, std::string>> solver_settings();

}  // namespace loosefit::validate
