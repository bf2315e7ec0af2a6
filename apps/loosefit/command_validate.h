#pragma once
#include <CLI/App.hpp>

namespace loosefit {

/// `loosefit validate`: carries out the benchmarks and holds them against their gates. Exit code 1
/// when a gate is missed that is not known to be, or by more than is known, or when one that is
/// stated to be missed is met.
void add_validate_command(CLI::App& app, int& exit_code);

}  // namespace loosefit
