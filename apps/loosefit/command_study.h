#pragma once
#include <CLI/App.hpp>

namespace loosefit {

/// `loosefit study plan | run | status | report | export | compare`: many cases (docs/studies.md).
void add_study_command(CLI::App& app, int& exit_code);

}  // namespace loosefit
