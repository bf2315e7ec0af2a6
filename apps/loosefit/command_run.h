#pragma once
#include <CLI/App.hpp>

namespace loosefit {

/// `loosefit run` and `loosefit drape`; `exit_code` is set when one of them ran.
void add_run_commands(CLI::App& app, int& exit_code);

}  // namespace loosefit
