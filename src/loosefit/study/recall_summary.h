#pragma once
#include <filesystem>

#include "loosefit/study/case_result.h"

namespace loosefit {

/// The way out where files of an earlier output are damaged or do not belong together.
inline constexpr char kMakeAgain[] = "make the drape again: loosefit run scenario.toml -o DIR";

/// Takes from the summary.json of an earlier output what only its drapes could tell: seconds and
/// counters of draping, also of the states of result.wear, and the spread over repeats unless
/// scenario.toml has been changed since. \throws IoError when it is missing, InvalidInput when it
/// is damaged.
void recall_summary(const std::filesystem::path& folder, CaseResult& result);

}  // namespace loosefit
