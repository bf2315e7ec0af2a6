#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/pipeline/case_result.h"
#include "loosefit/pipeline/run_case.h"
#include "loosefit/placement/ranking_table.h"

// Whole commands on the folder of a run, whose files appear all at once or not at all.
namespace loosefit::report {

/// What such a command has made.
struct FolderOutput {
  pipeline::CaseResult result;
  std::optional<placement::RankingTable> ranking;
  /// Folder in the output to which files that stood in the way were moved; mostly none.
  std::string set_aside;
};

/// `loosefit run` and `loosefit drape`: runs the scenario, ranks as it asks, and writes all files
/// with a log into a new folder or in place of an earlier output (RunFolder::create). A drape alone
/// gets neither pictures nor report.
/// \throws as run_case, rank_as_asked, write_output, RunFolder.
FolderOutput run_into_folder(const scenario::Scenario& scenario,
                             const std::filesystem::path& folder,
                             const pipeline::RunOptions& options, bool pictures,
                             Progress& progress);

/// What to make again of an earlier output beside maps and sites.
struct RedoOptions {
  std::vector<std::string> maps = {};  ///< instead of those of the scenario; empty: those
  bool allow_unsettled = false;
  bool pictures = false, report = false;  ///< the report with the ranking
};

/// `loosefit map`, `render` and `report`: takes an earlier output up again, makes the stages from
/// maps on anew and replaces their files. \throws as load_case, remap_case, write_output,
/// RunFolder.
FolderOutput redo_in_folder(const std::filesystem::path& folder, const RedoOptions& options,
                            Progress& progress);

}  // namespace loosefit::report
