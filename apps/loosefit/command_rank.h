#pragma once
#include <CLI/App.hpp>

namespace loosefit {

/// `loosefit rank`: ranks the sites of a run for a modality, or searches the best places.
void add_rank_command(CLI::App& app, int& exit_code);

}  // namespace loosefit
