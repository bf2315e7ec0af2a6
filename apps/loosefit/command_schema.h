#pragma once
#include <CLI/App.hpp>

namespace loosefit {

/// `loosefit schema`: the JSON Schema of scenarios, or with `--check` whether files are scenarios.
void add_schema_command(CLI::App& app, int& exit_code);

}  // namespace loosefit
