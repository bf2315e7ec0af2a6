#pragma once
#include <CLI/App.hpp>

namespace loosefit {

/// `loosefit material list` and `loosefit material show NAME`.
void add_material_command(CLI::App& app);

}  // namespace loosefit
