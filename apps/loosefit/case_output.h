#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "loosefit/base/progress.h"
#include "loosefit/placement/ranking_table.h"
#include "loosefit/study/case_result.h"

namespace loosefit {

/// Ranks as [ranking] of the scenario asks and writes the files of the ranking; timed as part of
/// "placement". Nothing when it asks for none or there are no maps. \throws as rank_cases.
std::optional<RankingTable> rank_as_asked(const std::filesystem::path& folder, CaseResult& result,
                                          Progress& progress);

/// What to write beside the data files.
struct OutputOptions {
  bool pictures = true;
  bool report = true;
  const RankingTable* ranking = nullptr;  ///< for the report
};

/// Writes all files of a case into `folder`: data, pictures and report (timed as stage "report" in
/// result.seconds), summary.json last. \throws IoError, Cancelled.
void write_output(const std::filesystem::path& folder, CaseResult& result,
                  const OutputOptions& options, Progress& progress);

/// Says on standard error, even to those who want it quiet, that files of `folder` were moved to
/// its folder `aside`; nothing when that is empty.
void tell_what_was_set_aside(const std::string& folder, const std::string& aside);

/// The result in a few lines on standard output.
void print_result(const CaseResult& result, const std::string& folder);

}  // namespace loosefit
