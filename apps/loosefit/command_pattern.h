#pragma once
#include <CLI/App.hpp>

namespace loosefit {

/// Adds `loosefit pattern`: drafts the shirt (from measures, a body file, a scenario or a garment
/// size) or reads a pattern file, prints girths, seams, areas and what of a file was not used, and
/// writes pattern.json and pattern.svg into a folder. The callback throws loosefit errors.
void add_pattern_command(CLI::App& app);

}  // namespace loosefit
