#pragma once
#include <functional>
#include <string>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/placement/site_ranking.h"

namespace loosefit::report {

/// A ranking over several runs as the samples of one population.
struct RankRuns {
  /// Folders of earlier runs or drapes, or scenario files, which are run first.
  std::vector<std::string> inputs;
  placement::RankingWish wish;
  bool with_sites = true;        ///< rank the sites of the first scenario, and presets
  bool allow_unsettled = false;  ///< rank even by a drape that is not settled and worn
  /// Folder for the files of the ranking; empty: the input, if it is a single folder, else none.
  std::string output;
};

/// What it gave.
struct RankedRuns {
  placement::RankingTable table;
  bool all_hold = true;   ///< the drapes of all runs are settled and worn
  std::string folder;     ///< with the files; empty when none were written
  std::string set_aside;  ///< as FolderOutput::set_aside
};

/// `loosefit rank`. `before_writing` gets the ranking before its files are written, which may fail.
/// \throws InvalidInput for the same input twice, which would count as two
/// samples; as load_case, run_case, rank_cases, RunFolder.
RankedRuns rank_runs(
    const RankRuns& asked, Progress& progress,
    const std::function<void(const placement::RankingTable&)>& before_writing = nullptr);

}  // namespace loosefit::report
