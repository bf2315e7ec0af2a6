#pragma once
#include <CLI/App.hpp>

namespace loosefit {

/// `loosefit validate`: carries out the benchmarks and holds them against their gates. Exit code 1
/// when a gate is missed.
void add_validate_command(CLI::App& app, int& exit_code);

}  // namespace loosefit
