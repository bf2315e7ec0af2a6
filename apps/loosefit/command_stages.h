#pragma once
#include <CLI/App.hpp>

namespace loosefit {

/// `loosefit map`, `render` and `report`: one stage each on the folder of an earlier run or drape.
void add_stage_commands(CLI::App& app, int& exit_code);

}  // namespace loosefit
