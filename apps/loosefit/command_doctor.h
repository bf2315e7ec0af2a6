#pragma once
#include <CLI/App.hpp>

namespace loosefit {

/// `loosefit doctor`: what is there, what is missing, how to get it. Exit code 2 when a run would
/// fail.
void add_doctor_command(CLI::App& app, int& exit_code);

}  // namespace loosefit
