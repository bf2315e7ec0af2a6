#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/base/progress.h"
#include "loosefit/pipeline/case_result.h"
#include "loosefit/placement/ranking_table.h"

// All files of a case.
namespace loosefit::report {

/// What to write beside the drape.
struct OutputParts {
  bool log = false, sites = true, pictures = true, report = true;
};

/// Names of the files that these parts of a scenario's output may have, relative to its folder:
/// asked before the simulation, which may then leave some out (postures that do not settle, maps of
/// a sealed drape). \throws as load_scorecard.
std::vector<std::string> planned_files(const scenario::Scenario& scenario,
                                       const OutputParts& parts);

/// A ranking, and what it took.
struct TimedRanking {
  placement::RankingTable table;
  double seconds = 0;
};

/// Ranks sites as [ranking] of the scenario asks, as part of stage "placement". Nothing when it
/// asks for none or there are no maps. Also makes the answers of the case, which say where to sew.
/// \throws as rank_cases.
std::optional<TimedRanking> rank_as_asked(pipeline::CaseResult& result, Progress& progress);

/// Writes the files of a case into `folder`, which exists: data, ranking when there is one,
/// pictures and report if `parts` asks for them, summary.json last. Returns the case with what that
/// took (stage "report", peak memory). Without a screen there are no pictures, and a warning.
/// \throws IoError, Cancelled.
pipeline::CaseResult write_output(const std::filesystem::path& folder, pipeline::CaseResult result,
                                  const OutputParts& parts,
                                  const std::optional<TimedRanking>& ranking, Progress& progress);

}  // namespace loosefit::report
