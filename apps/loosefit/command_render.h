#pragma once
#include <CLI/App.hpp>

namespace loosefit {

/// `loosefit render`: the pictures of a run again, or a figure of one or several runs.
void add_render_command(CLI::App& app, int& exit_code);

}  // namespace loosefit
