#pragma once
#include <CLI/App.hpp>

namespace loosefit {

/// Adds `loosefit body`: makes or reads a body, prints asked against measured and writes
/// body.obj, body.vtp and body.json into a folder. The callback throws loosefit errors.
void add_body_command(CLI::App& app);

}  // namespace loosefit
