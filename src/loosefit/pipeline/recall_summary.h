#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "loosefit/pipeline/case_result.h"

namespace loosefit::pipeline {

/// The way out where files of an earlier output are damaged or do not belong together.
inline constexpr char kMakeAgain[] = "make the drape again: loosefit run scenario.toml -o DIR";

/// What only its draping could tell of a state.
struct RecalledState {
  double seconds = 0;
  drape::SettleReport report;  ///< parts, and what makes contact less exact
  std::optional<drape::Unsettled> unsettled;
  std::string left_out;  ///< why the run itself had no drape of it; else empty
};

/// What only the drapes of a run could tell.
struct RecalledSummary {
  std::vector<StageClock::Entry> seconds;          ///< of draping
  drape::SettleReport report;                      ///< counters; without history
  std::map<std::string, std::string> draped_from;  ///< as of draped_from.h; empty: not kept
  std::vector<CaseMovement> movements;             ///< that were made once the garments were on
  std::optional<drape::Unsettled> unsettled;       ///< why the drape is not
  std::vector<std::string> dressing_warnings;
  CaseRepeats repeats;
  std::vector<RecalledState> states;  ///< as CaseWear::states
  std::vector<std::string> donning_warnings;
};

/// Reads it from the summary.json of an earlier output, of which `loaded` has scenario and states.
/// The spread over repeats is left out, with a warning, if scenario.toml has been changed since.
/// \throws IoError when it is missing, InvalidInput when it is damaged.
RecalledSummary recall_summary(const std::filesystem::path& folder, const CaseResult& loaded);

}  // namespace loosefit::pipeline
