#pragma once
#include <filesystem>
#include <vector>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// The way out where files of an earlier output are damaged or do not belong together.
inline constexpr char kMakeAgain[] = "make the drape again: loosefit run scenario.toml -o DIR";

/// What only the drapes of a run could tell.
struct RecalledSummary {
  std::vector<StageClock::Entry> seconds;  ///< of draping
  drape::SettleReport report;              ///< counters; without history
  std::vector<CaseMovement> movements;     ///< that were made once the garments were on
  CaseRepeats repeats;
  std::vector<double> state_seconds;  ///< as CaseWear::states
};

/// Reads it from the summary.json of an earlier output, of which `loaded` has scenario and states.
/// The spread over repeats is left out, with a warning, if scenario.toml has been changed since.
/// \throws IoError when it is missing, InvalidInput when it is damaged.
RecalledSummary recall_summary(const std::filesystem::path& folder, const CaseResult& loaded);

}  // namespace loosefit::pipeline
