#pragma once
#include <CLI/App.hpp>
#include <string>

#include "loosefit/report/run_into_folder.h"

namespace loosefit {

/// A stage to be made again on the folder of an earlier run or drape.
struct StageArguments {
  std::string folder;
  report::RedoOptions options;
  bool quiet = false, json = false;
};

/// Makes it and prints the result. Returns the exit code.
int redo_stage(const StageArguments& arguments);

/// `loosefit map` and `report`: one stage each on the folder of an earlier run or drape.
void add_stage_commands(CLI::App& app, int& exit_code);

}  // namespace loosefit
