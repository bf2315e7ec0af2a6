#pragma once
#include <string>

#include "loosefit/report/rank_runs.h"
#include "loosefit/report/run_into_folder.h"

// What commands that drape, map or rank say with `--json`; keys in docs/command-line.md.
namespace loosefit::report {

/// Verdict, warnings and files of `loosefit run`, `drape`, `map`, `render` and `report`; all
/// numbers are in the summary that it names.
std::string run_document(const FolderOutput& made, const std::string& folder);

/// The ranking as in ranking-NAME.json, with the folder and names of its files.
std::string rank_document(const RankedRuns& ranked);

}  // namespace loosefit::report
